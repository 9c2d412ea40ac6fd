// SPDX-License-Identifier: GPL-3.0-or-later
#include "programs.h"

#include <filesystem>
#include <sstream>

#include "child_process.h"

namespace fs = std::filesystem;

namespace filmsticking::bench {

std::string sibling_program(const std::string& name) {
  return (fs::read_symlink("/proc/self/exe").parent_path() / name).string();
}

std::map<std::string, MethodEntry> find_methods() {
  std::map<std::string, MethodEntry> methods;
  for (const char* name : {"run_method", "run_method_open3d"}) {
    const std::string program = sibling_program(name);
    if (name != std::string("run_method") && !fs::exists(program)) continue;
    std::istringstream lines(run_child({program, "--list"}, {}).out);
    for (std::string line; std::getline(lines, line);) {
      std::istringstream fields(line);
      std::string method, kind, description;
      std::getline(fields, method, '\t');
      std::getline(fields, kind, '\t');
      std::getline(fields, description);
      methods[method] = {program, description, kind != "time", kind == "sight"};
    }
  }
  return methods;
}

}  // namespace filmsticking::bench
