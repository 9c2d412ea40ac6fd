// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "io/model.h"

namespace filmsticking::scene {

/// A film of an evolution.
struct Step {
  std::string name;  ///< of its file
  io::Model film;
};

/// The meshes step_*.ply of a folder, as pcd_to_mesh --dump-steps writes them, in the order of their names.
/// Throws io::IoError, with the name of what is at fault.
std::vector<Step> read_steps(const std::string& folder);

}  // namespace filmsticking::scene
