// SPDX-License-Identifier: GPL-3.0-or-later
// capture_to_mesh: frames of a scanner in, one closed manifold mesh out.
#include <pcl/console/print.h>

#include <chrono>
#include <cinttypes>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "capture_bar.h"
#include "command_line.h"
#include "common/mesh_model.h"
#include "common/program.h"
#include "common/progress_bar.h"
#include "common/stop_signal.h"
#include "common/summary.h"
#include "common/usage_error.h"
#include "filters/model_filter.h"
#include "io/files.h"
#include "io/model_file.h"
#include "io/with_file.h"
#include "stream/accumulator.h"
#include "stream/background_mesher.h"
#include "stream/capture_error.h"
#include "stream/frame_source.h"

namespace fs = std::filesystem;
using namespace filmsticking;
using namespace filmsticking::app;
using io::with_file;

namespace {

constexpr const char* kName = "capture_to_mesh";

std::unique_ptr<capture::FrameSource> open_source(const CommandLine& command) {
  if (command.device) return capture::openni_source(*command.device);
  std::error_code error;
  if (command.inputs.size() == 1 && fs::is_directory(command.inputs[0], error))
    return capture::pcd_sequence(capture::pcd_files_in(command.inputs[0]));
  for (const std::string& input : command.inputs)
    with_file(input, [&] {
      std::error_code missing;
      if (!fs::exists(input, missing)) throw io::IoError("there is no such file or folder");
      const std::string extension = io::extension_of(input);
      if (extension != ".pcd" && (extension != ".oni" || command.inputs.size() > 1))
        throw io::IoError("a recording is a folder of .pcd files, .pcd files, or one .oni file");
      io::check_readable(input);
    });
  if (io::extension_of(command.inputs[0]) == ".oni") return capture::openni_source(command.inputs[0]);
  return capture::pcd_sequence(command.inputs);
}

std::unique_ptr<capture::PoseSource> open_poses(const CommandLine& command) {
  capture::RegistrationOptions registration;
  registration.min_overlap = command.min_overlap;
  registration.fit = command.align == Align::Icp ? capture::Fit::Icp : capture::Fit::Gicp;
  switch (command.align) {
    case Align::Poses:
      return with_file(command.poses, [&] {
        try {
          return capture::trajectory_poses(capture::parse_trajectory(io::read_file(command.poses)));
        } catch (const capture::CaptureError& error) {
          throw io::IoError(error.what());
        }
      });
    case Align::Sensor:
      return capture::sensor_poses();
    case Align::Auto:
      return capture::sensor_poses_or(capture::registered_poses(registration));
    default:
      return capture::registered_poses(registration);
  }
}

/// Refuses outputs that could not be written, before the work.
void check_outputs(const CommandLine& command) {
  for (const std::string& file : {command.output, command.save_cloud})
    if (!file.empty())
      with_file(file, [&] {
        if (!io::can_write_model(file))
          throw io::IoError("its extension is none of .ply .obj .stl .vtk .glb");
        io::check_writable(file);
      });
  if (!command.save_cloud.empty() && io::extension_of(command.save_cloud) != ".ply")
    throw UsageError("--save-cloud takes a .ply file");
  if (!command.save_poses.empty())
    with_file(command.save_poses, [&] { io::check_writable(command.save_poses); });
}

/// Writes meshes of what there is while the capture goes on.
class Previews {
 public:
  Previews(const CommandLine& command, CaptureBar& bar)
      : command_(command),
        bar_(bar),
        mesher_(command.options,
                {[this](double share, const char* room) {
                   bar_.show_mesh("mesh " + std::to_string(static_cast<int>(100 * share)) + " %, " + room);
                 },
                 [this](std::size_t frames, const io::Model& cloud, const Result& result) {
                   write(frames, cloud, result);
                 }}) {}

  /// To be called after each frame that was fused.
  void after(const capture::Accumulator& frames) {
    if (frames.placed().size() % static_cast<std::size_t>(command_.every) == 0) due_ = true;
    if (due_ && mesher_.idle())
      due_ = !mesher_.offer(frames.placed().size(), frames.points(command_.seen_by));
  }

 private:
  void write(std::size_t frames, const io::Model& cloud, const Result& result) noexcept {
    const std::string begin = "after " + std::to_string(frames) + (frames == 1 ? " frame: " : " frames: ");
    try {
      if (result.status == Status::Ok) {
        with_file(command_.output, [&] { io::write_model(command_.output, mesh_model(cloud, result)); });
        bar_.say(begin + std::to_string(result.vertices.size()) + " vertices, genus " +
                 std::to_string(result.report.genus) + ", written");
      } else {
        bar_.say(begin + "no mesh: " + reason(result));
      }
      bar_.show_mesh("");
    } catch (const std::exception& error) {
      bar_.say(begin + error.what());
    }
  }

  const CommandLine& command_;
  CaptureBar& bar_;
  bool due_ = false;
  capture::BackgroundMesher mesher_;  // last: its thread uses the others
};

/// Fuses all frames, or those up to a signal. How many could not even be read?
std::size_t capture_frames(const CommandLine& command, capture::FrameSource& source,
                           capture::Accumulator& accumulator) {
  CaptureBar bar;
  std::optional<Previews> previews;
  if (command.every > 0) previews.emplace(command, bar);
  const std::size_t most = command.frames > 0 ? static_cast<std::size_t>(command.frames) : 0;
  std::size_t seen = 0, unread = 0;
  const std::size_t stride = static_cast<std::size_t>(command.stride);
  std::optional<std::size_t> total = source.size();
  if (total) *total = (*total + stride - 1) / stride;
  if (most > 0 && (!total || most < *total)) total = most;

  for (std::size_t number = 0; !stop_asked && !source.at_end() && (most == 0 || seen < most);) {
    std::string name = "frame " + std::to_string(number + 1);
    std::optional<std::string> fault;
    try {
      const std::optional<capture::Frame> frame = source.next();
      if (!frame) continue;
      if (number++ % stride != 0) continue;
      ++seen;
      fault = accumulator.add(*frame);
      name = frame->name;
      if (!fault && previews) previews->after(accumulator);
      if (fault) fault = name + ": left out: " + *fault;
    } catch (const capture::CaptureError& error) {  // a frame that cannot be read
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

void save_poses(const CommandLine& command, const capture::Accumulator& accumulator) {
  if (command.save_poses.empty()) return;
  std::string text = "# time tx ty tz qx qy qz qw\n";
  double count = 0;
  for (const capture::Accumulator::Placed& frame : accumulator.placed())
    text += capture::trajectory_line(frame.time.value_or(count++), frame.pose);
  with_file(command.save_poses, [&] { io::write_file(command.save_poses, text); });
}

int run(const CommandLine& command) {
  const auto begin = std::chrono::steady_clock::now();
  check_outputs(command);
  capture::AccumulatorOptions options;
  options.filters = command.filters;
  options.filters.smoothing.reset();
  options.leaf = command.fuse;
  options.most_points = static_cast<std::size_t>(command.most_points);
  capture::Accumulator accumulator(options, open_poses(command));
  std::size_t unread = 0;
  {
    const std::unique_ptr<capture::FrameSource> source = open_source(command);
    stop_on_signal();
    unread = capture_frames(command, *source, accumulator);
  }
  if (accumulator.placed().empty())
    throw capture::CaptureError(accumulator.left_out() + unread > 0 ? "no frame could be used"
                                                                    : "no frame came");

  io::Model cloud = accumulator.points(command.seen_by);
  filters::FilterOptions last;
  last.smoothing = command.filters.smoothing;
  cloud = filters::filter(cloud, last);
  if (!command.save_cloud.empty())
    with_file(command.save_cloud, [&] { io::write_model(command.save_cloud, cloud); });
  save_poses(command, accumulator);

  Result result;
  {
    ProgressBar bar;
    Execution execution;
    execution.progress = [&bar](double share, const char* room) { bar.show(share, room); };
    result = reconstruct(cloud.positions, command.options, execution);
  }
  if (result.status != Status::Ok) throw capture::CaptureError(reason(result));
  const std::size_t points = cloud.positions.size();
  with_file(command.output, [&] { io::write_model(command.output, mesh_model(std::move(cloud), result)); });

  std::printf("frames  %zu used, %zu left out%s\n", accumulator.placed().size(),
              accumulator.left_out() + unread, stop_asked ? ", interrupted" : "");
  std::printf("cloud   %zu points, one a cell of %.3g\n", points, accumulator.leaf());
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  std::printf("%stook    %s\n", mesh_summary(result, command.output).c_str(), cost_summary(seconds).c_str());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);  // what goes wrong is said here, in a sentence
  return run_program(kName, [&] {
    const CommandLine command = parse_command_line(argc, argv);
    if (command.help) std::fputs(usage().c_str(), stdout);
    if (command.version) std::puts("capture_to_mesh " FILMSTICKING_VERSION);
    return command.help || command.version ? 0 : run(command);
  });
}
