// SPDX-License-Identifier: GPL-3.0-or-later
#include "scan_result.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "clouds/sample.h"
#include "csv.h"
#include "markdown.h"

namespace filmsticking::bench {
namespace {

Vec3 vector(const Point& p) { return {p[0], p[1], p[2]}; }

/// The component of each vertex, named by one of its vertices.
std::vector<std::size_t> components_of(const Mesh& mesh) {
  std::vector<std::size_t> parent(mesh.positions.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::int32_t vertex) {
    auto v = static_cast<std::size_t>(vertex);
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const Triangle& t : mesh.triangles)
    for (const int k : {1, 2}) parent[root(t[0])] = root(t[k]);
  for (std::size_t v = 0; v < parent.size(); ++v) parent[v] = root(static_cast<std::int32_t>(v));
  return parent;
}

bool is_vertex(const Mesh& mesh, const Point& p, double tolerance) {
  return std::any_of(mesh.positions.begin(), mesh.positions.end(),
                     [&](const Point& q) { return (vector(q) - vector(p)).norm() <= tolerance; });
}

std::size_t used_vertices(const Mesh& mesh) {
  std::vector<char> used(mesh.positions.size(), 0);
  for (const Triangle& t : mesh.triangles)
    for (const std::int32_t v : t) used[static_cast<std::size_t>(v)] = 1;
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), 1));
}

/// Components of the graph of edges with one face: rims that touch count as one.
int count_borders(const Mesh& mesh) {
  std::map<std::pair<std::int32_t, std::int32_t>, int> faces;
  for (const Triangle& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) ++faces[std::minmax(t[k], t[(k + 1) % 3])];
  Mesh rims{mesh.positions, {}};
  std::set<std::int32_t> on_rim;
  for (const auto& [edge, count] : faces) {
    if (count != 1) continue;
    rims.triangles.push_back({edge.first, edge.second, edge.second});
    on_rim.insert({edge.first, edge.second});
  }
  const std::vector<std::size_t> rim_of = components_of(rims);
  std::set<std::size_t> borders;
  for (const std::int32_t v : on_rim) borders.insert(rim_of[static_cast<std::size_t>(v)]);
  return static_cast<int>(borders.size());
}

using FloatPoint = std::array<float, 3>;

FloatPoint rounded_off(const Point& p) {
  return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
}

std::optional<double> front_share(const Mesh& mesh, const Scan& scan) {
  if (!scan.direction && scan.sensors.empty()) return std::nullopt;
  std::map<FloatPoint, Point> sensor_of;  // some methods round to single precision
  for (std::size_t i = 0; i < scan.sensors.size(); ++i)
    sensor_of[rounded_off(scan.points[i])] = scan.sensors[i];
  double front = 0, known = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = vector(mesh.positions[t[0]]), b = vector(mesh.positions[t[1]]),
               c = vector(mesh.positions[t[2]]);
    const Vec3 area = (b - a).cross(c - a);
    Vec3 to_sensors = Vec3::Zero();
    if (scan.direction) to_sensors = -vector(*scan.direction);
    for (const std::int32_t v : t)
      if (const auto seen = sensor_of.find(rounded_off(mesh.positions[v])); seen != sensor_of.end())
        to_sensors += (vector(seen->second) - vector(mesh.positions[v])).normalized();
    if (to_sensors.isZero()) continue;
    known += area.norm();
    if (area.dot(to_sensors) > 0) front += area.norm();
  }
  return known > 0 ? std::optional(front / known) : std::nullopt;
}

std::string shown(const std::optional<double>& value) { return rounded(value, 3); }

/// The first condition that the mesh does not meet.
std::string find_fault(const ScanResult& result, const Scan& scan) {
  const Row& row = result.row;
  if (scan.no_surface) {
    const bool said = !row.text("message").empty() && (row.ended_well() || row.is("status", "failed"));
    return said ? "" : "no warning";
  }
  if (!row.ended_well())
    return row.text("status") + (row.text("message").empty() ? "" : ": " + row.text("message"));
  if (scan.closed && !row.is("closed", "true")) return "not closed";
  if (scan.one_piece && !row.is("components", "1")) return row.text("components") + " components";
  if (scan.genus_zero && !row.is("genus", "0")) return "genus " + row.text("genus");
  if (std::isfinite(scan.tolerance) &&
      !(result.over_truth && std::abs(*result.over_truth - 1) <= scan.tolerance))
    return (scan.volume ? "volume " : "area ") + shown(result.over_truth) + " of the truth";
  if (!(result.longest_edge <= scan.longest_edge))
    return "an edge of " + shown(result.longest_edge) + " sizes";
  if (!(result.main_share >= scan.main_share))
    return "the main component has " + shown(result.main_share) + " of the area";
  if (!(result.used >= scan.least_used)) return shown(result.used) + " of the points used";
  if (scan.most_borders >= 0 && !(result.borders <= scan.most_borders))
    return std::to_string(result.borders.value_or(0)) + " borders";
  if (!(result.front.value_or(1) >= scan.least_front)) return "front on " + shown(result.front);
  if (result.needed < static_cast<std::int64_t>(scan.least_needed))
    return std::to_string(result.needed.value_or(0)) + " of " + std::to_string(scan.needed.size()) +
           " points used";
  return "";
}

}  // namespace

ScanMeasures measure_scan(const Mesh& mesh, const Scan& scan) {
  constexpr double kSamePlace = 1e-6;  // in sizes: some methods round to single precision
  ScanMeasures found;
  if (mesh.triangles.empty()) return found;
  const std::vector<std::size_t> component = components_of(mesh);
  std::vector<double> area_of(mesh.positions.size());
  const Vec3 origin = vector(mesh.positions.front());
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = vector(mesh.positions[t[0]]) - origin, b = vector(mesh.positions[t[1]]) - origin,
               c = vector(mesh.positions[t[2]]) - origin;
    const double area = (b - a).cross(c - a).norm() / 2;
    found.volume += a.dot(b.cross(c)) / 6;
    found.area += area;
    found.longest_edge = std::max({found.longest_edge, (b - a).norm(), (c - b).norm(), (a - c).norm()});
    area_of[component[t[0]]] += area;
  }
  found.main_share = *std::max_element(area_of.begin(), area_of.end()) / found.area;
  found.needed = std::count_if(scan.needed.begin(), scan.needed.end(),
                               [&](const Point& p) { return is_vertex(mesh, p, kSamePlace * scan.size); });
  found.used = static_cast<double>(used_vertices(mesh)) / static_cast<double>(scan.points.size());
  found.borders = count_borders(mesh);
  found.front = front_share(mesh, scan);
  return found;
}

void judge_scan(ScanResult& result, const Scan& scan, const ScanMeasures* measures) {
  if (measures) {
    const bool solid = result.row.is("closed", "true") && result.row.is("oriented", "true");
    if (scan.volume && solid) result.over_truth = measures->volume / *scan.volume;
    if (scan.area) result.over_truth = measures->area / *scan.area;
    result.longest_edge = measures->longest_edge / scan.size;
    result.main_share = measures->main_share;
    result.needed = measures->needed;
    result.used = measures->used;
    result.borders = measures->borders;
    result.front = measures->front;
  }
  result.wrong = find_fault(result, scan);
}

std::string scan_csv_header() {
  return csv_line({"kind",         "seed",       "method",       "points",     "right",       "wrong",
                   "status",       "message",    "seconds",      "closed",     "components",  "genus",
                   "interpolated", "over_truth", "longest_edge", "main_share", "needed_used", "used",
                   "borders",      "front",      "cpu_seconds"});
}

std::string scan_csv_line(const ScanResult& result) {
  const auto text = [](const std::optional<double>& value) { return value ? to_text(*value) : ""; };
  std::vector<std::string> fields = {result.kind,
                                     std::to_string(result.seed),
                                     result.method,
                                     std::to_string(result.points),
                                     result.wrong.empty() ? "true" : "false",
                                     result.wrong};
  for (const char* column : {"status", "message", "seconds", "closed", "components", "genus", "interpolated"})
    fields.push_back(result.row.text(column));
  fields.push_back(text(result.over_truth));
  fields.push_back(text(result.longest_edge));
  fields.push_back(text(result.main_share));
  fields.push_back(result.needed ? std::to_string(*result.needed) : "");
  fields.push_back(text(result.used));
  fields.push_back(result.borders ? std::to_string(*result.borders) : "");
  fields.push_back(text(result.front));
  fields.push_back(result.row.text("cpu_seconds"));
  return csv_line(fields);
}

}  // namespace filmsticking::bench
