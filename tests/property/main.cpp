// SPDX-License-Identifier: GPL-3.0-or-later
// property_test: what reconstruct() promises for any points, on many generated ones.
#include <tbb/global_control.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

#include "filmsticking/reconstruct.h"
#include "grid_subsets.h"
#include "invariance.h"
#include "nasty_cloud.h"
#include "promise.h"
#include "replay.h"
#include "sweep.h"

using namespace filmsticking;
using namespace filmsticking::test;

namespace {

constexpr int kPatience = 600, kMostFaults = 50;  // seconds; then a sweep has shown enough

constexpr double kMostWithout = 0;    // a share of the grid's sets that span space
constexpr double kLeastMeshes = 0.4;  // a share of the clouds

constexpr char kUsage[] =
    "usage: property_test clouds|holes|orders|moves|turns COUNT [FIRST]\n"
    "       property_test grid EVERY|all\n"
    "       property_test replay clouds|holes|orders|moves|turns|grid NUMBER [FILE.xyz]\n\n"
    "  clouds   COUNT nasty clouds, numbered from FIRST (default 0), keep the promise\n"
    "  holes    and that for open meshes with lids over small holes\n"
    "  orders   their meshes are the same in another order, run, scale, and number of threads\n"
    "  moves    those of clouds of dyadic numbers are the same when all points are moved by powers of two\n"
    "  turns    and when they are turned by 90 degrees\n"
    "  grid     of the sets of 4 to 8 points of a 3x3x3 grid, up to its symmetries, each EVERYth; or all, "
    "in\n"
    "           every position\n"
    "  replay   one of them again, in a process of its own; the fewest points that still fail go to the "
    "file\n\n"
    "FILMSTICKING_PROPERTY_FACTOR=N multiplies COUNT, and divides EVERY. Exit status: 0 without a fault.\n";

std::atomic<std::uint64_t> meshes{0};  // that cloud_fault() has seen

std::string cloud_fault(const std::vector<Point>& points) {
  Options options;
  options.threads = 1;  // the clouds are what is done side by side
  const Result result = reconstruct(points, options);
  meshes += result.status == Status::Ok;
  return fault_of(result, points);
}

std::atomic<std::uint64_t> without_surface{0};  // that grid_fault() has seen

/// A grid's set is a mesh unless it is flat; few may come to nothing.
std::string grid_fault(const std::vector<Point>& points) {
  GridSet set = 0;
  for (const Point& p : points) set |= GridSet{1} << static_cast<int>(p[0] + 3 * p[1] + 9 * p[2]);
  Options options;
  options.threads = 1;
  const Result result = reconstruct(points, options);
  const std::string wrong = fault_of(result, points);
  if (!wrong.empty() || points.size() < 4) return wrong;
  without_surface += result.status == Status::NoSurface;
  const bool flat = on_one_plane(set);
  return flat == (result.status == Status::Coplanar) ? "" : flat ? "it is flat" : "it is not flat";
}

/// Away from the ends of the numbers, so that scaling is exact; and not too many, for several runs.
std::vector<Point> order_cloud(std::uint64_t seed) {
  std::vector<Point> points = nasty_cloud(seed);
  points.resize(std::min<std::size_t>(points.size(), 400));
  for (Point& p : points)
    for (double& x : p)
      if (std::abs(x) > 1e280 || std::abs(x) < 1e-290) x = 0;
  return points;
}

/// A few points, with holes closed up to a diameter that the points choose.
std::vector<Point> holed_cloud(std::uint64_t seed) {
  std::vector<Point> points = order_cloud(seed);
  points.resize(std::min<std::size_t>(points.size(), 150));
  return points;
}

std::string hole_fault(const std::vector<Point>& points) {
  Options options;
  options.threads = 1;
  const Point first = points.empty() ? Point{} : points.front(),
              last = points.empty() ? Point{} : points.back();
  options.max_hole = std::hypot(first[0] - last[0], first[1] - last[1], first[2] - last[2]) / 3;
  if (!std::isfinite(options.max_hole)) options.max_hole = 1;
  const Result result = reconstruct(points, options);
  const std::string wrong = fault_of(result, points, options.max_hole > 0);
  if (!wrong.empty() || result.status != Status::Ok) return wrong;
  std::int64_t open = 0;
  for (const Hole& hole : result.report.holes) {
    if (hole.closed && hole.diameter > options.max_hole * (1 + 1e-9))
      return "a hole that is too wide has a lid";
    open += hole.closed ? 0 : 1;
  }
  return open == result.report.boundary_loops ? "" : "the list of holes is not that of the mesh";
}

struct Property {
  const char* name;
  std::vector<Point> (*cloud)(std::uint64_t);
  std::string (*fault)(const std::vector<Point>&);
};

constexpr Property kProperties[] = {
    {"clouds", nasty_cloud, cloud_fault},
    {"holes", holed_cloud, hole_fault},
    {"orders", order_cloud, [](const std::vector<Point>& p) { return invariance_fault(p, p.size()); }},
    {"moves", dyadic_cloud, move_fault},
    {"turns", dyadic_cloud, turn_fault},
    {"grid", [](std::uint64_t set) { return points_of(static_cast<GridSet>(set)); }, grid_fault},
};

const Property& property(const std::string& name) {
  for (const Property& one : kProperties)
    if (one.name == name) return one;
  throw std::invalid_argument("no property " + name);
}

std::uint64_t factor() {
  const char* text = std::getenv("FILMSTICKING_PROPERTY_FACTOR");
  return text ? std::stoull(text) : 1;
}

int grid(const std::string& every) {
  const bool all = every == "all";
  const std::vector<GridSet> sets = grid_sets(4, 8, !all);
  const std::uint64_t step = all ? 1 : std::max<std::uint64_t>(1, std::stoull(every) / factor());
  const std::size_t count = (sets.size() + step - 1) / step;
  const int faults = sweep("grid", 0, count, kPatience, kMostFaults, [&](std::uint64_t i) {
    const GridSet set = sets[i * step];
    const std::string wrong = grid_fault(points_of(set));
    return wrong.empty() ? "" : "set " + std::to_string(set) + ": " + wrong;
  });
  std::printf("%llu of them without a surface\n", static_cast<unsigned long long>(without_surface.load()));
  return faults > 0 || static_cast<double>(without_surface) > kMostWithout * static_cast<double>(count);
}

int replay(const Property& what, std::uint64_t number, const char* file) {
  const auto fault = [&](const std::vector<Point>& points) {
    return isolated(what.fault, points, kPatience);
  };
  const std::vector<Point> points = what.cloud(number);
  const std::string wrong = fault(points);
  std::printf("%s %llu: %zu points, %s\n", what.name, static_cast<unsigned long long>(number), points.size(),
              wrong.empty() ? "no fault" : wrong.c_str());
  if (wrong.empty() || !file) return wrong.empty() ? 0 : 1;
  const std::vector<Point> few = shrink(points, fault);
  write_points(file, few);
  std::printf("wrote %s: %zu points\n", file, few.size());
  return 1;
}

int run(const std::vector<std::string>& words) {
  if (words.size() >= 3 && words[0] == "replay")
    return replay(property(words[1]), std::stoull(words[2]), words.size() > 3 ? words[3].c_str() : nullptr);
  if (words.size() == 2 && words[0] == "grid") return grid(words[1]);
  if (words.size() < 2 || words.size() > 3) throw std::invalid_argument("wrong number of words");
  const Property& what = property(words[0]);
  const std::uint64_t count = std::stoull(words[1]) * factor(),
                      first = words.size() > 2 ? std::stoull(words[2]) : 0;
  const int faults = sweep(what.name, first, first + count, kPatience, kMostFaults,
                           [&](std::uint64_t seed) { return what.fault(what.cloud(seed)); });
  if (what.fault != cloud_fault || faults > 0) return faults > 0;
  // A promise that is kept by refusing everything is worth nothing.
  std::printf("%llu of them became meshes\n", static_cast<unsigned long long>(meshes.load()));
  return static_cast<double>(meshes) < kLeastMeshes * static_cast<double>(count);
}

}  // namespace

int main(int argc, char** argv) {
  // As many threads as are asked for, on any machine.
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 8);
  try {
    return run(std::vector<std::string>(argv + 1, argv + argc));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "property_test: %s\n%s", error.what(), kUsage);
    return 2;
  }
}
