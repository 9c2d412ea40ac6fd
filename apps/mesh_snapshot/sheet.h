// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <string>
#include <vector>

#include "io/model.h"
#include "scene/camera.h"
#include "scene/drawing.h"

namespace filmsticking::app {

/// A mesh and the numbers that it and the points over it are painted by; empty: plain.
struct Film {
  io::Model mesh;  ///< without triangles: nothing
  scene::Values face_values, point_values;
};

/// One place of the picture.
struct Panel {
  std::vector<Film> films;  ///< one, or those of an evolution; at least one
  std::string label;        ///< written under it; empty: none
};

/// What shares one scale and one middle.
enum class Fit {
  All,   ///< all panels
  Row,   ///< the panels of a row
  Each,  ///< nothing: every mesh fills its panel
};

/// How the meshes are looked at; the same for all.
struct View {
  int width = 700;  ///< of the whole picture, in pixels
  int height = 700;
  int columns = 1;  ///< panels in a row
  scene::Angles angles;
  scene::Style style;
  Fit fit = Fit::All;
};

/// Draws the panels, each with `cloud` over it, and hands the pictures to `take` one by one. With `turns` > 1
/// there are as many, from views spread evenly around the upright axis, and evolutions go on meanwhile; else
/// one for each film of the longest evolution. Needs an X display.
void draw_sheet(const std::vector<Panel>& panels, const io::Model& cloud, const View& view, int turns,
                const std::function<void(vtkSmartPointer<vtkImageData>)>& take);

}  // namespace filmsticking::app
