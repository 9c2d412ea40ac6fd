// SPDX-License-Identifier: GPL-3.0-or-later
#include "step_dump.h"

#include <cstdio>
#include <filesystem>

#include "common/stop_signal.h"
#include "io/formats.h"
#include "io/with_file.h"

namespace filmsticking::app {

void StepDump::write(int step, const Mesh& film) noexcept {
  if (!error_.empty()) return;
  try {
    char name[32];
    std::snprintf(name, sizeof name, "step_%03d.ply", step);
    const std::string path = (std::filesystem::path(folder_) / name).string();
    io::with_file(path, [&] { io::write_mesh(path, io::make_cloud(film.positions), film.triangles); });
  } catch (const std::exception& error) {
    error_ = error.what();
    stop_asked = true;
  }
}

}  // namespace filmsticking::app
