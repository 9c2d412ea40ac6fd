// SPDX-License-Identifier: GPL-3.0-or-later
// pcd_to_mesh: a file of points in, a file with a closed manifold mesh out.
#include <sys/resource.h>

#include <atomic>
#include <chrono>
#include <cinttypes>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <new>

#include "command_line.h"
#include "filmsticking/reconstruct.h"
#include "io/files.h"
#include "io/io_error.h"
#include "io/model_file.h"
#include "io/with_file.h"
#include "progress_bar.h"
#include "report_json.h"

namespace fs = std::filesystem;
using namespace filmsticking;
using namespace filmsticking::app;
using io::with_file;

namespace {

constexpr int kFailed = 1, kWrongUsage = 2, kInterrupted = 130;

std::atomic<bool> stop{false};

/// The first signal asks for a clean end, a second one ends the program at once.
void stop_on_signal() {
  struct sigaction action = {};
  action.sa_handler = [](int) { stop = true; };
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

/// Refuses outputs that could not be written, before the work.
void check_outputs(const CommandLine& command) {
  with_file(command.output, [&] {
    if (!io::can_write_model(command.output))
      throw io::IoError("its extension is none of .ply .obj .stl .vtk");
    std::error_code error;
    if (fs::equivalent(command.input, command.output, error)) throw io::IoError("it is the input");
    io::check_writable(command.output);
  });
  if (!command.report.empty()) with_file(command.report, [&] { io::check_writable(command.report); });
  if (!command.dump_steps.empty())
    with_file(command.dump_steps, [&] { fs::create_directories(command.dump_steps); });
}

/// Writes the film of each step; the first file that cannot be written stops the run.
class StepDump {
 public:
  explicit StepDump(std::string folder) : folder_(std::move(folder)) {}

  void write(int step, const Mesh& film) noexcept {
    if (!error_.empty()) return;
    try {
      char name[32];
      std::snprintf(name, sizeof name, "step_%03d.ply", step);
      const std::string path = (fs::path(folder_) / name).string();
      with_file(path, [&] { io::write_model(path, {film.positions, {}, film.triangles}); });
    } catch (const std::exception& error) {
      error_ = error.what();
      stop = true;
    }
  }

  const std::string& error() const { return error_; }

 private:
  std::string folder_;
  std::string error_;
};

io::Model to_model(const io::Model& cloud, const Result& result) {
  io::Model mesh;
  mesh.triangles = result.triangles;
  for (const std::int32_t index : result.vertices) {
    mesh.positions.push_back(cloud.positions[index]);
    if (!cloud.colours.empty()) mesh.colours.push_back(cloud.colours[index]);
  }
  return mesh;
}

std::int64_t peak_memory_bytes() {
  struct rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return std::int64_t{usage.ru_maxrss} * 1024;
}

void print_summary(const Result& result, const RunFacts& facts) {
  const Report& report = result.report;
  const double share = 100.0 * static_cast<double>(report.interpolated) / static_cast<double>(report.sites);
  std::printf("read %s: %" PRId64 " points (%" PRId64 " not finite, %" PRId64 " repeated)\n",
              facts.input.c_str(), report.points, report.non_finite, report.duplicates);
  std::printf("film: %zu steps, %d rounds, %" PRId64
              " points inserted; %.2f %% of the points are on the mesh\n",
              report.steps.size(), report.rounds, report.inserted, share);
  std::printf("mesh: %zu vertices, %zu triangles, %" PRId64 " component%s, genus %" PRId64 ", %s, %s\n",
              result.vertices.size(), result.triangles.size(), report.components,
              report.components == 1 ? "" : "s", report.genus, report.closed ? "closed" : "not closed",
              report.manifold ? "manifold" : "not manifold");
  std::printf("wrote %s in %.1f s, peak memory %.0f MB\n", facts.output.c_str(), facts.seconds,
              static_cast<double>(facts.peak_memory_bytes) / 1e6);
}

int run(const CommandLine& command) {
  const auto begin = std::chrono::steady_clock::now();
  stop_on_signal();
  const io::Model cloud = with_file(command.input, [&] { return io::read_cloud(command.input); });
  check_outputs(command);

  StepDump dump(command.dump_steps);
  Result result;
  {
    ProgressBar bar;
    Execution execution;
    execution.progress = [&bar](double share, const char* room) { bar.show(share, room); };
    execution.cancel = &stop;
    if (!command.dump_steps.empty())
      execution.on_step = [&dump](int step, const Mesh& film) { dump.write(step, film); };
    result = reconstruct(cloud.positions, command.options, execution);
  }
  if (!dump.error().empty()) throw io::IoError(dump.error());

  if (result.status == Status::Ok)
    with_file(command.output, [&] { io::write_model(command.output, to_model(cloud, result)); });
  RunFacts facts{command.input, command.output, 0, peak_memory_bytes()};
  facts.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (!command.report.empty())
    with_file(command.report, [&] { io::write_file(command.report, report_json(result, facts)); });

  if (result.status == Status::Ok) {
    print_summary(result, facts);
    return 0;
  }
  const std::string reason = result.message.empty() ? describe(result.status) : result.message;
  std::fprintf(stderr, "pcd_to_mesh: %s: %s.\n", command.input.c_str(), reason.c_str());
  return result.status == Status::Cancelled ? kInterrupted : kFailed;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const CommandLine command = parse_command_line(argc, argv);
    if (command.help) std::fputs(usage().c_str(), stdout);
    if (command.version) std::puts("pcd_to_mesh " FILMSTICKING_VERSION);
    return command.help || command.version ? 0 : run(command);
  } catch (const UsageError& error) {
    std::fprintf(stderr, "pcd_to_mesh: %s.\n", error.what());
    return kWrongUsage;
  } catch (const std::bad_alloc&) {
    std::fputs("pcd_to_mesh: the memory does not suffice.\n", stderr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "pcd_to_mesh: %s.\n", error.what());
  }
  return kFailed;
}
