// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "contents.h"
#include "scene/camera.h"

namespace filmsticking::app {

/// Among keys to press: a pause of one tick, in which films play.
constexpr char kWait[] = "wait";

/// The first state of the window.
struct WindowOptions {
  int width = 1000, height = 750;  ///< pixels
  scene::Angles angles;
  std::string screenshot = "mesh_view.png";  ///< with a number before the extension where the name is taken
  std::vector<std::string> keys;             ///< pressed one by one in the open window; or kWait
};

/// Shows a window of pcl::visualization::PCLVisualizer until it is closed. Needs an X display.
void show_window(Contents& contents, const WindowOptions& options);

}  // namespace filmsticking::app
