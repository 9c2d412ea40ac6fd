// SPDX-License-Identifier: GPL-3.0-or-later
// capture_to_mesh: frames of a scanner in, one closed manifold mesh out.
#include <pcl/console/print.h>

#include <atomic>
#include <chrono>
#include <cinttypes>
#include <cstdio>
#include <filesystem>
#include <set>
#include <string>
#include <utility>

#include "capture_bar.h"
#include "command_line.h"
#include "common/program.h"
#include "common/progress_bar.h"
#include "common/stop_signal.h"
#include "common/summary.h"
#include "common/usage_error.h"
#include "filters/filter_chain.h"
#include "io/files.h"
#include "io/formats.h"
#include "io/with_file.h"
#include "stream/accumulator.h"
#include "stream/frame_source.h"
#include "stream/make_mesh.h"
#include "stream/newest_wins.h"
#include "stream/stream_error.h"

namespace fs = std::filesystem;
using namespace filmsticking;
using namespace filmsticking::app;
using io::with_file;

namespace {

constexpr const char* kName = "capture_to_mesh";

void write_mesh(const CommandLine& command, pcl::PolygonMesh mesh) {
  if (!command.doubles && io::float_suffices(mesh.cloud))
    mesh.cloud = io::with_float_positions(std::move(mesh.cloud));
  with_file(command.output, [&] { io::write_mesh(command.output, mesh); });
}

std::unique_ptr<stream::FrameSource> open_source(const CommandLine& command) {
  if (command.device) return stream::openni_source(*command.device);
  std::error_code error;
  if (command.inputs.size() == 1 && fs::is_directory(command.inputs[0], error))
    return stream::file_sequence(stream::frame_files_in(command.inputs[0]));
  for (const std::string& input : command.inputs)
    with_file(input, [&] {
      std::error_code missing;
      if (!fs::exists(input, missing)) throw io::IoError("there is no such file or folder");
      const bool recording = io::extension_of(input) == ".oni" && command.inputs.size() == 1;
      if (!recording && !stream::is_frame_file(input))
        throw io::IoError(
            "a recording is a folder of .pcd, .ply, .las, .ptx, .pts or .xyz files, such files, or one .oni "
            "file");
      io::check_readable(input);
    });
  if (io::extension_of(command.inputs[0]) == ".oni") return stream::openni_source(command.inputs[0]);
  return stream::file_sequence(command.inputs);
}

stream::PoseSource open_poses(const CommandLine& command) {
  stream::RegistrationOptions registration;
  registration.min_overlap = command.min_overlap;
  registration.fit = command.align == Align::Icp ? stream::Fit::Icp : stream::Fit::Gicp;
  switch (command.align) {
    case Align::Poses:
      return with_file(command.poses, [&] {
        try {
          return stream::trajectory_poses(stream::parse_trajectory(io::read_file(command.poses)));
        } catch (const stream::StreamError& error) {
          throw io::IoError(error.what());
        }
      });
    case Align::Sensor:
      return stream::sensor_poses();
    case Align::Auto:
      return stream::sensor_poses_or(stream::registered_poses(registration));
    default:
      return stream::registered_poses(registration);
  }
}

/// Refuses outputs that could not be written, before the work.
void check_outputs(const CommandLine& command) {
  for (const std::string& file : {command.output, command.save_cloud})
    if (!file.empty())
      with_file(file, [&] {
        if (!io::can_write_mesh(file))
          throw io::IoError("its extension is none of " + io::extensions_of(io::mesh_formats()));
        io::check_writable(file);
      });
  if (!command.save_cloud.empty() && io::extension_of(command.save_cloud) != ".ply")
    throw UsageError("--save-cloud takes a .ply file");
  if (!command.save_poses.empty())
    with_file(command.save_poses, [&] { io::check_writable(command.save_poses); });
}

/// Writes meshes of the frames so far while the capture goes on.
class Previews {
 public:
  Previews(const CommandLine& command, CaptureBar& bar) : command_(command), bar_(bar) {}

  /// Call it after each frame that was fused. A mesh that is due waits until the last one is done.
  void after(const stream::Accumulator& frames) {
    if (frames.placed().size() % static_cast<std::size_t>(command_.every) == 0) due_ = true;
    if (!due_ || mesher_.busy()) return;
    mesher_.submit({frames.placed().size(), {frames.cloud(command_.seen_by), {}, command_.options}});
    due_ = false;
  }

 private:
  struct Job {
    std::size_t frames;
    stream::MeshJob mesh;
  };

  void work(Job& job, const std::atomic<bool>& cancel) noexcept {
    const stream::Outcome outcome =
        stream::make_mesh(std::move(job.mesh), &cancel, [this](double share, const char* stage) {
          bar_.show_mesh("mesh " + std::to_string(static_cast<int>(100 * share)) + " %, " + stage);
        });
    if (outcome.status == Status::Cancelled) return;
    const std::string begin =
        "after " + std::to_string(job.frames) + (job.frames == 1 ? " frame: " : " frames: ");
    try {
      if (outcome.status == Status::Ok) {
        write_mesh(command_, outcome.mesh);
        bar_.say(begin + std::to_string(io::size_of(outcome.mesh.cloud)) + " vertices, genus " +
                 std::to_string(outcome.report.genus) + ", written");
      } else {
        bar_.say(begin + "no mesh: " + outcome.message);
      }
      bar_.show_mesh("");
    } catch (const std::exception& error) {
      bar_.say(begin + error.what());
    }
  }

  const CommandLine& command_;
  CaptureBar& bar_;
  bool due_ = false;
  stream::NewestWins<Job> mesher_{[this](Job& job, auto, const std::atomic<bool>& cancel) {
    work(job, cancel);
  }};  // last: its thread uses the others
};

/// Fuses all frames, or those up to a signal. Returns how many could not be read.
std::size_t capture_frames(const CommandLine& command, stream::FrameSource& source,
                           stream::Accumulator& accumulator) {
  CaptureBar bar;
  std::optional<Previews> previews;
  if (command.every > 0) previews.emplace(command, bar);
  const std::size_t most = command.frames > 0 ? static_cast<std::size_t>(command.frames) : 0;
  std::size_t seen = 0, unread = 0;
  std::set<std::string> said;
  const std::size_t stride = static_cast<std::size_t>(command.stride);
  std::optional<std::size_t> total = source.size();
  if (total) *total = (*total + stride - 1) / stride;
  if (most > 0 && (!total || most < *total)) total = most;

  for (std::size_t number = 0; !stop_asked && !source.at_end() && (most == 0 || seen < most);) {
    std::string name = "frame " + std::to_string(number + 1);
    std::optional<std::string> fault;
    try {
      const std::optional<stream::Frame> frame = source.next();
      if (!frame) continue;
      if (number++ % stride != 0) continue;
      ++seen;
      fault = accumulator.add(*frame);
      name = frame->name;
      for (const std::string& note : frame->notes)  // most often all frames have the same ones
        if (said.insert(note).second) bar.say(std::string(kName) + ": " + name + ": " + note + ".");
      if (!fault && previews) previews->after(accumulator);
      if (fault) fault = name + ": left out: " + *fault;
    } catch (const stream::StreamError& error) {  // a frame that cannot be read
      ++number;
      ++seen;
      ++unread;
      fault = std::string(error.what()) + "; left out";
    }
    if (fault) bar.say(std::string(kName) + ": " + *fault + ".");
    bar.show_frames(total ? static_cast<double>(seen) / static_cast<double>(*total) : 0,
                    "frame " + std::to_string(seen) + (total ? " of " + std::to_string(*total) : "") + ", " +
                        std::to_string(accumulator.size()) + " points");
  }
  return unread;
}

void save_poses(const CommandLine& command, const stream::Accumulator& accumulator) {
  if (command.save_poses.empty()) return;
  std::string text = "# time tx ty tz qx qy qz qw\n";
  double count = 0;
  for (const stream::Accumulator::Placed& frame : accumulator.placed())
    text += stream::trajectory_line(frame.time.value_or(count++), frame.pose);
  with_file(command.save_poses, [&] { io::write_file(command.save_poses, text); });
}

/// The fused points of all frames; `unread`: how many frames could not be read.
stream::Accumulator capture(const CommandLine& command, std::size_t& unread) {
  stream::AccumulatorOptions options;
  options.filters = command.filters;
  options.filters.smoothing.reset();
  options.width = command.fuse;
  options.most_points = static_cast<std::size_t>(command.most_points);
  stream::Accumulator accumulator(options, open_poses(command));
  const std::unique_ptr<stream::FrameSource> source = open_source(command);
  stop_on_signal();
  unread = capture_frames(command, *source, accumulator);
  if (accumulator.placed().empty())
    throw stream::StreamError(accumulator.left_out() + unread > 0 ? "no frame could be used"
                                                                  : "no frame came");
  return accumulator;
}

int run(const CommandLine& command) {
  const auto begin = std::chrono::steady_clock::now();
  check_outputs(command);
  std::size_t unread = 0;
  const stream::Accumulator accumulator = capture(command, unread);

  filters::FilterOptions last;
  last.smoothing = command.filters.smoothing;
  stream::MeshJob job{filters::filter(accumulator.cloud(command.seen_by), last), {}, command.options};
  if (!command.save_cloud.empty())
    with_file(command.save_cloud,
              [&] { io::write_mesh(command.save_cloud, io::with_named_stations(job.cloud), {}); });
  save_poses(command, accumulator);

  const std::size_t points = io::size_of(job.cloud);
  ProgressBar bar;
  const stream::Outcome outcome = stream::make_mesh(
      std::move(job), nullptr, [&bar](double share, const char* stage) { bar.show(share, stage); });
  bar.hide();
  if (outcome.status != Status::Ok) throw stream::StreamError(outcome.message);
  write_mesh(command, outcome.mesh);

  std::printf("frames  %zu used, %zu left out%s\n", accumulator.placed().size(),
              accumulator.left_out() + unread, stop_asked ? ", interrupted" : "");
  std::printf("cloud   %zu points, one a cell of %.3g\n", points, accumulator.width());
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  std::printf("%stook    %s\n", mesh_summary(outcome.report, command.output).c_str(),
              cost_summary(seconds).c_str());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);  // this program reports errors itself
  return run_program(kName, [&] {
    const CommandLine command = parse_command_line(argc, argv);
    if (command.help) std::fputs(usage().c_str(), stdout);
    if (command.version) std::puts("capture_to_mesh " FILMSTICKING_VERSION);
    return command.help || command.version ? 0 : run(command);
  });
}
