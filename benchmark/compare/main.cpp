// SPDX-License-Identifier: GPL-3.0-or-later
// compare: FilmstickingPP and its peers on the same clouds.
#include <cstdio>

#include "berger.h"
#include "clouds/scan_kinds.h"
#include "command_line.h"
#include "common/program.h"
#include "normals.h"
#include "programs.h"
#include "quality.h"
#include "sample.h"
#include "scans.h"
#include "sheet.h"
#include "speed.h"

using namespace filmsticking::bench;

namespace {

void help() {
  std::fputs(usage().c_str(), stdout);
  std::puts("\nMethods:");
  for (const auto& [name, entry] : find_methods())
    std::printf("  %-22s %s\n", name.c_str(), entry.description.c_str());
  std::puts("\nKinds of scans:");
  for (const ScanKind& kind : scan_kinds()) std::printf("  %-22s %s\n", kind.name, kind.description);
}

void run(const CommandLine& command) {
  switch (command.mode) {
    case CommandLine::Mode::Quality:
      return compare_quality(command);
    case CommandLine::Mode::Speed:
      return compare_speed(command);
    case CommandLine::Mode::Sheet:
      return draw_sheet(command);
    case CommandLine::Mode::Sample:
      return write_sample(command);
    case CommandLine::Mode::Scans:
      return compare_scans(command);
    case CommandLine::Mode::Normals:
      return compare_normals(command);
    case CommandLine::Mode::Berger:
      return compare_berger(command);
  }
}

}  // namespace

int main(int argc, char** argv) {
  return filmsticking::app::run_program("compare", [&] {
    const CommandLine command = parse_command_line(argc, argv);
    if (command.help) {
      help();
    } else {
      run(command);
    }
    return 0;
  });
}
