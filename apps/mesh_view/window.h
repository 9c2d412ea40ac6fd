// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "contents.h"
#include "scene/camera.h"

namespace filmsticking::app {

/// Among keys to press: none for a moment, in which what is played goes on.
constexpr char kWait[] = "wait";

/// How the window comes up.
struct WindowOptions {
  int width = 1000, height = 750;  ///< pixels
  scene::Angles angles;
  std::string screenshot = "mesh_view.png";  ///< a number is put before the ending where that is taken
  std::vector<std::string> keys;             ///< pressed one by one when it is open; or kWait
};

/// Shows a window of pcl::visualization::PCLVisualizer until it is closed. Needs an X display.
void show_window(Contents& contents, const WindowOptions& options);

}  // namespace filmsticking::app
