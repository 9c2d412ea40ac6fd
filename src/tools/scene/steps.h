// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pcl/PolygonMesh.h>

#include <string>
#include <vector>

namespace filmsticking::scene {

/// The film after one step.
struct Step {
  std::string name;  ///< of its file
  pcl::PolygonMesh film;
};

/// The meshes step_*.ply of a folder, as pcd_to_mesh --dump-steps writes them, in the order of their names.
/// Throws io::IoError with the file's name.
std::vector<Step> read_steps(const std::string& folder);

}  // namespace filmsticking::scene
