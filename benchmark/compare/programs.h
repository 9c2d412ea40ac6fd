// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

namespace filmsticking::bench {

/// The path of a program in the folder of this one.
std::string sibling_program(const std::string& name);

/// A method and the program that holds it.
struct MethodEntry {
  std::string program;
  std::string description;
  bool makes_mesh = true;
  bool needs_sight = false;  ///< it takes only clouds whose sensors are known
};

/// All methods by name, of run_method and, where it was built, of run_method_open3d. Throws
/// std::runtime_error without run_method.
std::map<std::string, MethodEntry> find_methods();

}  // namespace filmsticking::bench
