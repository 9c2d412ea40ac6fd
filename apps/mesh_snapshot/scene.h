// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "io/model.h"

namespace filmsticking::app {

/// One mesh of the picture.
struct Panel {
  io::Model mesh;     ///< without triangles: the panel stays empty
  std::string label;  ///< written under it; empty: none
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
  int columns = 1;          ///< panels in a row
  double azimuth = 30;      ///< degrees around the upright axis
  double elevation = 20;    ///< degrees above the horizon
  bool z_up = false;        ///< the upright axis is z, else y
  bool edges = false;       ///< draw the edges of the triangles
  bool grey_backs = false;  ///< back faces are grey, not red
  Fit fit = Fit::All;
};

/// Draws the panels, each with `points` over it, and returns the bytes of a PNG file. Needs an X display.
std::string render_png(const std::vector<Panel>& panels, const std::vector<Point>& points, const View& view);

}  // namespace filmsticking::app
