// SPDX-License-Identifier: GPL-3.0-or-later
#include "normals.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "cloud_files.h"
#include "cloud_list.h"
#include "clouds/make_cloud.h"
#include "csv.h"
#include "filmsticking/normals.h"
#include "filmsticking/reconstruct.h"
#include "io/files.h"
#include "markdown.h"
#include "methods/oriented_normals.h"
#include "methods/pcl_normals.h"
#include "methods/stopwatch.h"
#include "row.h"
#include "statistics.h"

namespace filmsticking::bench {
namespace {

constexpr double kDegrees = 57.29577951308232;

struct NormalMethod {
  const char* name;
  std::vector<Point> (*run)(const std::vector<Point>& points);
};

std::vector<Point> our_normals(const std::vector<Point>& points) {
  const Result result = reconstruct(points);
  std::vector<Normal> normals;
  if (result.status == Status::Ok) point_normals(points, result.vertices, result.triangles, normals);
  std::vector<Point> out(points.size(), Point{});  // without a surface no sign is right
  for (std::size_t i = 0; i < normals.size(); ++i) out[i] = {normals[i][0], normals[i][1], normals[i][2]};
  return out;
}

const NormalMethod kMethods[] = {
    {"ours", our_normals}, {"cgal-mst", oriented_normals}, {"pcl-centroid", pcl_normals}};

double mean_angle(const std::vector<Point>& normals, const std::vector<Sample>& samples) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (samples[i].normal.isZero()) continue;
    const Eigen::Map<const Vec3> n(normals[i].data());
    sum += std::acos(std::clamp(n.dot(samples[i].normal), -1.0, 1.0)) * kDegrees;
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0;
}

struct Measured {
  std::vector<double> right, angle, seconds;  // an entry a cloud
};

std::string shown(const Measured& of, std::size_t at) {
  return rounded(100 * of.right[at], 4) + " %, " + rounded(of.angle[at], 3) + " degrees, " +
         rounded(of.seconds[at], 3) + " s";
}

}  // namespace

double right_signs(const std::vector<Point>& normals, const std::vector<Sample>& samples) {
  std::size_t right = 0, known = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (samples[i].normal.isZero()) continue;
    ++known;
    right += Eigen::Map<const Vec3>(normals[i].data()).dot(samples[i].normal) > 0 ? 1 : 0;
  }
  return known > 0 ? static_cast<double>(right) / static_cast<double>(known) : 0;
}

void compare_normals(const CommandLine& command) {
  std::vector<std::pair<std::string, std::map<std::string, Measured>>> kinds;  // in the order of the clouds
  std::string csv = csv_line({"shape", "kind", "points", "seed", "method", "right", "angle", "seconds"});
  for (const CloudPlan& plan : list_clouds(command)) {
    const Row row = cloud_row(plan.input, plan.spec);
    const std::vector<Sample> samples = make_samples(read_input(plan.input, plan.spec.points), plan.spec);
    std::vector<Point> points;
    for (const Sample& s : samples) points.push_back({s.position.x(), s.position.y(), s.position.z()});
    const std::string kind = row.text("kind") + ", " + row.text("points");
    if (kinds.empty() || kinds.back().first != kind)
      kinds.emplace_back(kind, std::map<std::string, Measured>());
    for (const NormalMethod& method : kMethods) {
      Stopwatch watch;
      const std::vector<Point> normals = method.run(points);
      Measured& of = kinds.back().second[method.name];
      of.seconds.push_back(watch.lap());
      of.right.push_back(right_signs(normals, samples));
      of.angle.push_back(mean_angle(normals, samples));
      csv += csv_line({row.text("shape"), row.text("kind"), row.text("points"), row.text("seed"), method.name,
                       to_text(of.right.back()), to_text(of.angle.back()), to_text(of.seconds.back())});
      std::fprintf(stderr, "%s, %s: %s: %s\n", plan.input.name.c_str(), kind.c_str(), method.name,
                   shown(of, of.right.size() - 1).c_str());
    }
  }
  std::vector<std::vector<std::string>> table = {
      {"cloud, points", "method", "right signs, mean", "worst", "angle, mean", "seconds, mean"}};
  for (const auto& [kind, by_method] : kinds)
    for (const NormalMethod& method : kMethods) {
      const Measured& of = by_method.at(method.name);
      table.push_back({kind, method.name, rounded(100 * *mean(of.right), 4) + " %",
                       rounded(100 * *std::min_element(of.right.begin(), of.right.end()), 4) + " %",
                       rounded(mean(of.angle), 3), rounded(mean(of.seconds), 3)});
    }
  if (!command.csv.empty()) publish(csv, command.csv);
  publish(markdown_table(table), command.markdown);
}

}  // namespace filmsticking::bench
