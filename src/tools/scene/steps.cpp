// SPDX-License-Identifier: GPL-3.0-or-later
#include "steps.h"

#include <algorithm>
#include <filesystem>

#include "io/formats.h"
#include "io/with_file.h"

namespace fs = std::filesystem;

namespace filmsticking::scene {

std::vector<Step> read_steps(const std::string& folder) {
  std::vector<fs::path> files;
  io::with_file(folder, [&] {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
      const std::string name = entry.path().filename().string();
      if (name.rfind("step_", 0) == 0 && entry.path().extension() == ".ply") files.push_back(entry.path());
    }
    if (files.empty()) throw io::IoError("there is no step_*.ply in it");
  });
  // A number with more digits is a larger one.
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    const std::string left = a.filename().string(), right = b.filename().string();
    return left.size() != right.size() ? left.size() < right.size() : left < right;
  });
  std::vector<Step> steps;
  steps.reserve(files.size());
  for (const fs::path& file : files)
    steps.push_back({file.filename().string(),
                     io::with_file(file.string(), [&] { return io::read_mesh(file.string()); })});
  return steps;
}

}  // namespace filmsticking::scene
