// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_task.h"

#include <pcl/point_types.h>
#include <pcl/surface/filmsticking_pp.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <utility>

#include "common/stop_signal.h"
#include "common/summary.h"
#include "filmsticking/normals.h"
#include "filters/filter_chain.h"
#include "filters/on_ground.h"
#include "io/files.h"
#include "io/formats.h"
#include "io/merge.h"
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

void take_notes(const std::string& file, io::Cloud& cloud, std::vector<std::string>& notes) {
  const std::string begin = file + ": ";
  for (const std::string& note : cloud.notes) notes.push_back(begin + note);
  cloud.notes.clear();
}

/// A file's cloud; what is to be said of it goes to `notes`.
io::Cloud read_input(const std::string& path, const CommandLine& command, std::vector<std::string>& notes) {
  const std::string name = shown(path, "standard input");
  return with_file(name, [&] {
    const io::ReadOptions options{command.options.max_memory, command.from, command.columns,
                                  command.merge || command.batch};
    io::Cloud cloud = path != kStandardStream
                          ? io::read_cloud(path, options)
                          : io::decode_any(io::read_standard_input(options.most, &stop_asked), "", options);
    take_notes(name, cloud, notes);
    return cloud;
  });
}

/// The clouds of all files of a task as one.
io::Cloud read_inputs(const Task& task, const CommandLine& command, std::vector<std::string>& notes) {
  io::Cloud cloud = read_input(task.input, command, notes);
  for (const std::string& file : task.more) {
    io::append(cloud, read_input(file, command, notes));
    take_notes(file, cloud, notes);
  }
  return cloud;
}

void check_points_out(const Task& task, const std::string& path) {
  const auto same = [&](const std::string& other) {
    std::error_code error;
    return fs::weakly_canonical(path, error) == fs::weakly_canonical(other, error);
  };
  if (same(task.output)) throw io::IoError("the points and the mesh cannot be one file");
  if (same(task.input) || std::any_of(task.more.begin(), task.more.end(), same))
    throw io::IoError("it is an input");

  if (!io::can_write_cloud(path))
    throw io::IoError("its extension is none of " + io::extensions_of(io::written_cloud_formats()));
  io::check_writable(path);
}

/// Refuses an output that could not be written, before the work.
void check_output(const Task& task, const CommandLine& command) {
  const bool is_ply =
      task.output == kStandardStream ? command.to == "ply" : io::extension_of(task.output) == ".ply";
  if (command.normals && !is_ply) throw io::IoError("--normals needs a .ply, which alone keeps them");
  if (task.output == kStandardStream) {
    if (isatty(STDOUT_FILENO) && command.to != "obj")
      throw io::IoError("it is a terminal; send it to a file or a program");
    return;
  }
  if (!io::can_write_mesh(task.output))
    throw io::IoError("its extension is none of " + io::extensions_of(io::mesh_formats()));
  std::error_code error;
  if (fs::equivalent(task.input, task.output, error)) throw io::IoError("it is the input");
  for (const std::string& file : task.more)
    if (fs::equivalent(file, task.output, error)) throw io::IoError("it is an input");
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
    cloud = read_inputs(task, command, facts.notes);
  } catch (const io::IoError&) {
    outcome.interrupted = stop_asked;
    throw;
  }
  facts.read = static_cast<std::int64_t>(io::size_of(cloud.points));
  with_file(facts.output, [&] { check_output(task, command); });
  if (!command.points_out.empty())
    with_file(command.points_out, [&] { check_points_out(task, command.points_out); });
  if (!command.filters.any() && !command.ground.asked) return cloud;
  try {
    if (command.filters.any()) cloud.points = filters::filter(cloud.points, command.filters);
    cloud.viewpoints = io::viewpoints_of(cloud.points);
    if (command.ground.asked) {
      filters::OnGround standing = filters::on_ground(cloud.points, command.ground);
      facts.ground = standing.plane;
      facts.on_ground = standing.on_plane;
      facts.added = standing.added;
      cloud = {std::move(standing.points)};
      cloud.viewpoints = io::viewpoints_of(cloud.points);
      // Nobody saw the points that were added.
      const std::size_t seen =
          cloud.viewpoints.size() - std::min<std::size_t>(cloud.viewpoints.size(), standing.added);
      std::fill(cloud.viewpoints.begin() + static_cast<std::ptrdiff_t>(seen), cloud.viewpoints.end(),
                Point{NAN, NAN, NAN});
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

/// The mesh's vertices and the cloud's points, with all fields of the cloud.
struct Reconstructed {
  pcl::PCLPointCloud2 vertices;
  pcl::PCLPointCloud2::ConstPtr points;
  std::vector<Normal> normals;  // of `points`; empty unless they are asked for
};

/// Of the box of the finite points.
double diagonal_of(const pcl::PCLPointCloud2& cloud) {
  Point low, high;
  low.fill(std::numeric_limits<double>::infinity()), high.fill(-low[0]);
  for (const Point& p : io::positions_of(cloud)) {
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) continue;
    for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
  }
  return low[0] > high[0] ? 0 : std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
}

/// Fills `result` but for its gaps.
Reconstructed reconstruct(io::Cloud cloud, const CommandLine& command, const Progress& progress,
                          StepDump& dump, Result& result) {
  pcl::FilmstickingPP<pcl::PointXYZ> filmsticking;
  filmsticking.useNoViewPoint();  // but for one that is given
  Options options = command.options;
  if (!options.viewpoint) options.viewpoint = cloud.viewpoint, options.trust_viewpoint = false;
  if (!cloud.viewpoints.empty())
    options.viewpoints = std::make_shared<const std::vector<Point>>(std::move(cloud.viewpoints));
  options.max_hole = command.max_hole.value * (command.max_hole.is_share ? diagonal_of(cloud.points) : 1);
  filmsticking.setOptions(options);
  filmsticking.setProgressCallback(progress);
  filmsticking.setCancelFlag(&stop_asked);
  if (!command.dump_steps.empty())
    filmsticking.setStepCallback([&dump](int step, const Mesh& film) { dump.write(step, film); });
  filmsticking.setComputeNormals(command.normals || !command.points_out.empty());
  Reconstructed made;
  made.points = std::make_shared<pcl::PCLPointCloud2>(std::move(cloud.points));
  filmsticking.setInputBlob(made.points);
  filmsticking.reconstruct(made.vertices, result.triangles);
  result.status = filmsticking.getStatus();
  result.message = filmsticking.getStatusMessage();
  result.report = filmsticking.getReport();
  result.vertices = filmsticking.getVertexIndices();
  result.stability = filmsticking.getFaceStability();
  made.normals.reserve(filmsticking.getNormals().size());
  for (const pcl::Normal& n : filmsticking.getNormals())
    made.normals.push_back({n.normal_x, n.normal_y, n.normal_z});
  return made;
}

pcl::PCLPointCloud2 with_normals_of(const pcl::PCLPointCloud2& vertices, const Result& result,
                                    const std::vector<Normal>& of_points) {
  std::vector<Normal> normals;
  for (const std::int32_t i : result.vertices) normals.push_back(of_points[static_cast<std::size_t>(i)]);
  return io::with_normals(vertices, normals);
}

void run(const Task& task, const CommandLine& command, const Progress& progress, TaskResult& outcome) {
  io::Cloud cloud = read_and_filter(task, command, outcome);
  StepDump dump(command.dump_steps);
  const std::optional<Point> viewpoint = cloud.viewpoint;
  std::vector<Point> points;
  if (!command.html.empty()) points = io::positions_of(cloud.points);
  Reconstructed made = reconstruct(std::move(cloud), command, progress, dump, outcome.result);
  pcl::PCLPointCloud2& vertices = made.vertices;
  outcome.reached = true;
  if (!dump.error().empty()) throw io::IoError(dump.error());
  outcome.interrupted = outcome.result.status == Status::Cancelled;
  if (outcome.result.status != Status::Ok)
    throw io::IoError(outcome.facts.input + ": " + outcome.result.message);
  if (command.options.stability)
    vertices =
        with_file(outcome.facts.input, [&] { return coloured_by_stability(vertices, outcome.result); });
  if (command.normals)
    vertices = with_file(outcome.facts.input,
                         [&] { return with_normals_of(vertices, outcome.result, made.normals); });
  if (!command.points_out.empty())
    with_file(command.points_out, [&] {
      io::write_cloud(command.points_out, {io::with_normals(*made.points, made.normals), viewpoint});
    });
  if (!command.doubles && io::float_suffices(vertices))
    vertices = io::with_float_positions(std::move(vertices));
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
  if (!task.more.empty()) outcome.facts.input += " and " + std::to_string(task.more.size()) + " more";
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
