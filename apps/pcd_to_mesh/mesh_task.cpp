// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_task.h"

#include <pcl/point_types.h>
#include <pcl/surface/filmsticking_pp.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <new>
#include <utility>

#include "common/stop_signal.h"
#include "common/summary.h"
#include "filters/filter_chain.h"
#include "filters/on_ground.h"
#include "io/files.h"
#include "io/formats.h"
#include "io/with_file.h"
#include "mesh_page.h"
#include "step_dump.h"

namespace fs = std::filesystem;

namespace filmsticking::app {
namespace {

using io::with_file;

std::string shown(const std::string& path, const char* stream) {
  return path == kStandardStream ? stream : path;
}

io::Cloud read_input(const std::string& path, const CommandLine& command) {
  const std::int64_t most = command.options.max_memory;
  if (path != kStandardStream && command.from.empty()) return io::read_cloud(path, most);
  const std::string bytes =
      path == kStandardStream ? io::read_standard_input(most, &stop_asked) : io::read_file(path, most);
  const std::string known = command.from.empty() ? io::detect_format(bytes) : command.from;
  if (known.empty()) throw io::IoError("its format is not recognised; --format names it");
  io::Cloud cloud = io::decode_cloud(known, bytes);
  if (io::size_of(cloud.points) == 0) throw io::IoError("there are no points in it");
  return cloud;
}

/// Refuses an output that could not be written, before the work.
void check_output(const Task& task, const CommandLine& command) {
  if (task.output == kStandardStream) {
    if (isatty(STDOUT_FILENO) && command.to != "obj")
      throw io::IoError("it is a terminal; send it to a file or a program");
    return;
  }
  if (!io::can_write_mesh(task.output))
    throw io::IoError("its extension is none of " + io::extensions_of(io::mesh_formats()));
  std::error_code error;
  if (fs::equivalent(task.input, task.output, error)) throw io::IoError("it is the input");
  io::check_writable(task.output);
}

void write_output(const Task& task, const CommandLine& command, const pcl::PCLPointCloud2& vertices,
                  const std::vector<Triangle>& triangles) {
  if (task.output == kStandardStream) {
    io::encode_mesh(command.to, vertices, triangles, io::write_standard_output);
  } else {
    io::write_mesh(task.output, vertices, triangles);
  }
}

io::Cloud read_and_filter(const Task& task, const CommandLine& command, TaskResult& outcome) {
  RunFacts& facts = outcome.facts;
  io::Cloud cloud;
  try {
    cloud = with_file(facts.input, [&] { return read_input(task.input, command); });
  } catch (const io::IoError&) {
    outcome.interrupted = stop_asked;
    throw;
  }
  facts.read = static_cast<std::int64_t>(io::size_of(cloud.points));
  with_file(facts.output, [&] { check_output(task, command); });
  if (!command.filters.any() && !command.ground.asked) return cloud;
  try {
    if (command.filters.any()) cloud.points = filters::filter(cloud.points, command.filters);
    cloud.viewpoints = io::viewpoints_of(cloud.points);
    if (command.ground.asked) {
      filters::OnGround standing = filters::on_ground(cloud.points, command.ground);
      facts.ground = standing.plane;
      facts.on_ground = standing.on_plane;
      facts.added = standing.added;
      cloud = {std::move(standing.points)};  // nobody saw the points that were added
    }
  } catch (const filters::FilterError& error) {
    throw io::IoError(facts.input + ": " + error.what());
  }
  if (io::size_of(cloud.points) == 0) throw io::IoError(facts.input + ": the filters leave no point");
  return cloud;
}

/// The places of the vertices, from white, where all faces around are stable, to red.
pcl::PCLPointCloud2 coloured_by_stability(const pcl::PCLPointCloud2& vertices, const Result& result) {
  if (result.stability.empty())
    throw io::IoError("this surface has no stability, as that of a depth image; leave --stability out");
  std::vector<double> sum(result.vertices.size(), 0), faces(result.vertices.size(), 0);
  for (std::size_t t = 0; t < result.triangles.size(); ++t)
    for (const std::int32_t v : result.triangles[t])
      sum[static_cast<std::size_t>(v)] += result.stability[t], ++faces[static_cast<std::size_t>(v)];
  std::vector<io::Colour> colours;
  for (std::size_t v = 0; v < sum.size(); ++v) {
    const auto pale = static_cast<std::uint8_t>(255 * sum[v] / faces[v]);
    colours.push_back({255, pale, pale});
  }
  return io::make_cloud(io::positions_of(vertices), colours);
}

/// Fills `result` but for its gaps; returns the vertices with all fields of the cloud.
pcl::PCLPointCloud2 reconstruct(io::Cloud cloud, const CommandLine& command, const Progress& progress,
                                StepDump& dump, Result& result) {
  pcl::FilmstickingPP<pcl::PointXYZ> filmsticking;
  filmsticking.useNoViewPoint();  // but for one that is given
  Options options = command.options;
  if (!options.viewpoint) options.viewpoint = cloud.viewpoint;
  filmsticking.setOptions(options);
  filmsticking.setProgressCallback(progress);
  filmsticking.setCancelFlag(&stop_asked);
  if (!command.dump_steps.empty())
    filmsticking.setStepCallback([&dump](int step, const Mesh& film) { dump.write(step, film); });
  filmsticking.setInputBlob(std::make_shared<pcl::PCLPointCloud2>(std::move(cloud.points)));
  pcl::PCLPointCloud2 vertices;
  filmsticking.reconstruct(vertices, result.triangles);
  result.status = filmsticking.getStatus();
  result.message = filmsticking.getStatusMessage();
  result.report = filmsticking.getReport();
  result.vertices = filmsticking.getVertexIndices();
  result.stability = filmsticking.getFaceStability();
  return vertices;
}

void run(const Task& task, const CommandLine& command, const Progress& progress, TaskResult& outcome) {
  io::Cloud cloud = read_and_filter(task, command, outcome);
  StepDump dump(command.dump_steps);
  std::vector<Point> points;
  if (!command.html.empty()) points = io::positions_of(cloud.points);
  pcl::PCLPointCloud2 vertices = reconstruct(std::move(cloud), command, progress, dump, outcome.result);
  outcome.reached = true;
  if (!dump.error().empty()) throw io::IoError(dump.error());
  outcome.interrupted = outcome.result.status == Status::Cancelled;
  if (outcome.result.status != Status::Ok)
    throw io::IoError(outcome.facts.input + ": " + outcome.result.message);
  if (command.options.stability)
    vertices =
        with_file(outcome.facts.input, [&] { return coloured_by_stability(vertices, outcome.result); });
  with_file(outcome.facts.output, [&] { write_output(task, command, vertices, outcome.result.triangles); });
  if (!command.html.empty())
    with_file(command.html, [&] {
      write_mesh_page(command.html, fs::path(outcome.facts.output).filename().string(), points, vertices,
                      outcome.result.triangles);
    });
}

}  // namespace

TaskResult run_task(const Task& task, const CommandLine& command, const Progress& progress) noexcept {
  const auto begin = std::chrono::steady_clock::now();
  TaskResult outcome;
  outcome.facts.input = shown(task.input, "standard input");
  outcome.facts.output = shown(task.output, "standard output");
  try {
    run(task, command, progress, outcome);
  } catch (const std::bad_alloc&) {
    outcome.error = outcome.facts.input + ": the memory does not suffice";
  } catch (const std::exception& error) {
    outcome.error = error.what();
  }
  outcome.facts.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  outcome.facts.peak_memory_bytes = peak_memory_bytes();
  return outcome;
}

}  // namespace filmsticking::app
