// SPDX-License-Identifier: GPL-3.0-or-later
// run_method: one method on one cloud, in a process of its own. Prints one line of JSON.
#include <sys/resource.h>
#include <tbb/global_control.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <new>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "io/formats.h"
#include "io/io_error.h"
#include "method.h"

using namespace filmsticking;
using namespace filmsticking::bench;

namespace {

constexpr int kFailed = 1, kWrongUsage = 2, kOutOfMemory = 3;

/// Of this process with all its threads, in seconds.
double cpu_seconds() {
  struct rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// A value of /proc/self/status, in MB of 10^6 bytes. Not getrusage, whose peak begins with that of the
/// parent.
double memory_mb(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.rfind(name + ":", 0) == 0) return std::strtod(line.c_str() + name.size() + 1, nullptr) * 1024e-6;
  return 0;
}

const Method* find_method(const std::string& name) {
  for (const Method& method : methods())
    if (name == method.name) return &method;
  return nullptr;
}

int list() {
  for (const Method& method : methods())
    std::printf("%s\t%s\t%s\n", method.name,
                !method.makes_mesh ? "time"
                : method.run_seen  ? "sight"
                                   : "mesh",
                method.description);
  return 0;
}

/// "X,Y,Z"; nothing for anything else.
std::optional<Point> direction_of(const char* text) {
  Point p{};
  return text && std::sscanf(text, "%lf,%lf,%lf", &p[0], &p[1], &p[2]) == 3 ? std::optional(p) : std::nullopt;
}

SeenCloud read_seen(const std::string& path, const std::optional<Point>& direction) {
  io::Cloud cloud = io::read_cloud(path);
  SeenCloud seen{io::positions_of(cloud.points), std::move(cloud.viewpoints), direction};
  if (seen.sensors.empty() && cloud.viewpoint) seen.sensors.assign(seen.points.size(), *cloud.viewpoint);
  return seen;
}

int run(const Method& method, const SeenCloud& cloud, const std::string& mesh_path, int threads) {
  const std::vector<Point>& points = cloud.points;
  if (method.run_seen && cloud.sensors.empty() && !cloud.direction)
    throw std::runtime_error("it needs to know where the points were seen from");
  std::optional<tbb::global_control> limit;
  if (threads > 0)
    limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));

  const double memory_before = memory_mb("VmRSS"), cpu_before = cpu_seconds();
  const Outcome outcome = method.run_seen ? method.run_seen(cloud, threads) : method.run(points, threads);
  const double cpu = cpu_seconds() - cpu_before, peak = memory_mb("VmHWM");

  if (method.makes_mesh) {
    if (outcome.mesh.triangles.empty()) throw std::runtime_error("it made no triangles");
    io::write_mesh(mesh_path, io::make_cloud(outcome.mesh.positions), outcome.mesh.triangles);
  }
  nlohmann::ordered_json stages = nlohmann::ordered_json::object();
  for (const RoomSeconds& stage : outcome.rooms) stages[stage.room] = stage.seconds;
  const nlohmann::ordered_json json = {{"method", method.name},
                                       {"points", points.size()},
                                       {"seconds", outcome.seconds},
                                       {"seconds_with_needs", outcome.seconds + outcome.needs_seconds},
                                       {"cpu_seconds", cpu},
                                       {"memory_mb", peak},
                                       {"memory_before_mb", memory_before},
                                       {"warning", outcome.warning},
                                       {"rooms", stages},
                                       {"steps", outcome.steps},
                                       {"fields", outcome.fields}};
  // The last line, as some libraries print too.
  std::fflush(stdout);
  std::printf("%s\n", json.dump().c_str());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string program = argv[0] ? argv[0] : "run_method";
  if (argc == 2 && std::strcmp(argv[1], "--list") == 0) return list();
  const std::optional<Point> direction = direction_of(argc == 6 ? argv[5] : nullptr);
  if (argc < 4 || argc > 6 || (argc == 6 && !direction)) {
    std::fputs("usage: run_method NAME CLOUD OUT.ply [THREADS [X,Y,Z]]\n       run_method --list\n", stderr);
    return kWrongUsage;
  }
  const Method* method = find_method(argv[1]);
  if (!method) {
    std::fprintf(stderr, "run_method: there is no method \"%s\" here; --list prints the methods.\n", argv[1]);
    return kWrongUsage;
  }
  try {
    return run(*method, read_seen(argv[2], direction), argv[3], argc > 4 ? std::atoi(argv[4]) : 0);
  } catch (const std::bad_alloc&) {
    std::fputs("run_method: the memory does not suffice.\n", stderr);
    return kOutOfMemory;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "run_method: %s.\n", error.what());
  } catch (...) {
    std::fputs("run_method: something was thrown that is no exception.\n", stderr);
  }
  return kFailed;
}
