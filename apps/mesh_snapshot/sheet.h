// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <string>
#include <vector>

#include "io/cloud.h"
#include "scene/camera.h"
#include "scene/drawing.h"

namespace filmsticking::app {

/// A mesh, and values to show as colours of its faces and of the points; empty: plain.
struct Film {
  pcl::PolygonMesh mesh;  ///< without triangles: nothing
  scene::Values face_values, point_values;
};

/// One place of the picture.
struct Panel {
  std::vector<Film> films;  ///< one, or one a step; at least one
  std::string label;        ///< written under it; empty: none
};

/// The panels that share one scale and one middle.
enum class Fit {
  All,   ///< all
  Row,   ///< the panels of a row
  Each,  ///< none: every mesh fills its panel
};

/// The view of all panels.
struct View {
  int width = 700;  ///< of the whole picture, in pixels
  int height = 700;
  int columns = 1;  ///< panels in a row
  scene::Angles angles;
  scene::Style style;
  Fit fit = Fit::All;
};

/// Draws the panels, each with `cloud` over it, and passes the pictures to `take` one by one. `turns` > 1:
/// that many pictures, from views spread evenly around the upright axis, with the steps spread over them;
/// else one for each step of the longest panel. Needs an X display.
void draw_sheet(const std::vector<Panel>& panels, const pcl::PCLPointCloud2& cloud, const View& view,
                int turns, const std::function<void(vtkSmartPointer<vtkImageData>)>& take);

}  // namespace filmsticking::app
