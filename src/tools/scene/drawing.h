// SPDX-License-Identifier: GPL-3.0-or-later
// What both programs draw: VTK's actors of meshes and clouds.
#pragma once

#include <vtkProp.h>
#include <vtkRenderer.h>
#include <vtkScalarsToColors.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

#include "camera.h"
#include "io/cloud.h"

namespace filmsticking::scene {

/// A number for each face or point to be shown as a colour; empty: none.
using Values = std::vector<double>;

/// How things are drawn.
struct Style {
  bool edges = false;       ///< the edges of the triangles
  bool grey_backs = false;  ///< back faces are grey, not red
  bool colours = false;     ///< the colours that the files have, where they have some
  bool holes = true;        ///< edges of holes red, edges with more than two faces violet
  double point_size = 3;    ///< in pixels
  double scale = 1;         ///< the value at the end of the colour scale
};

/// The colours of a scale from zero to `length`: pale yellow, green, blue; the last one also beyond, grey for
/// NaN.
vtkSmartPointer<vtkScalarsToColors> make_colour_table(double length);

/// The finite faces of a mesh, moved so that `middle` is the origin, and the edges of its holes. `values`:
/// empty, or one a face, shown as colours of both sides.
std::vector<vtkSmartPointer<vtkProp>> draw_mesh(const pcl::PolygonMesh& mesh, const Values& values,
                                                const Point& middle, const Style& style);

/// The finite points of a cloud. `values`: empty, or one a point, shown as colours.
vtkSmartPointer<vtkProp> draw_points(const pcl::PCLPointCloud2& cloud, const Values& values,
                                     const Point& middle, const Style& style);

/// A text at the lower edge, in the middle; `size` in points.
vtkSmartPointer<vtkProp> draw_label(const std::string& text, int size = 18);

/// A text of several lines at the upper left, in a face that keeps columns.
vtkSmartPointer<vtkProp> draw_help(const std::string& text);

/// The scale of colours with numbers, at the right edge; scale_bar_share() is its Margins::right. `width`: of
/// the picture, in pixels.
vtkSmartPointer<vtkProp> draw_scale_bar(const std::string& title, double length, double width);
double scale_bar_share(double width);

/// A white background, and lights that go with the camera.
void light(vtkRenderer* renderer);

}  // namespace filmsticking::scene
