// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample.h"

#include <filesystem>

#include "cloud_files.h"
#include "cloud_list.h"
#include "io/formats.h"
#include "io/io_error.h"
#include "scratch_folder.h"

namespace filmsticking::bench {

void write_sample(const CommandLine& command) {
  const CloudPlan plan = list_clouds(command).front();
  const ScratchFolder scratch;
  const CloudFiles files = prepare_cloud(plan.input, plan.spec, true, scratch / "cloud");
  try {
    io::write_mesh(command.output, io::read_cloud(files.cloud).points, {});
  } catch (const io::IoError& error) {
    throw std::runtime_error(command.output + ": " + error.what());
  }
}

}  // namespace filmsticking::bench
