// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "report.h"

namespace filmsticking::mesh_report {
namespace {

using Rows = std::vector<std::pair<std::string, std::string>>;

/// Names and values.
class Table {
 public:
  void add(const std::string& name, const std::string& value) { rows_.emplace_back(name, value); }
  Rows rows() && { return std::move(rows_); }

 private:
  Rows rows_;
};

std::string yes(bool value) { return value ? "yes" : "no"; }

/// "3 edges", "1 vertex".
std::string count(std::int64_t n, const char* one, const char* many) {
  return std::to_string(n) + ' ' + (n == 1 ? one : many);
}

std::string number(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string number_or_dash(const char* format, const std::optional<double>& value) {
  return value ? number(format, *value) : "-";
}

std::string closed(const Topology& topology) {
  if (topology.closed || topology.edges == 0) return yes(topology.closed);
  return "no, " + count(topology.boundary_edges, "boundary edge", "boundary edges");
}

std::string manifold(const Topology& topology) {
  if (topology.manifold || topology.edges == 0) return yes(topology.manifold);
  return "no, " + count(topology.non_manifold_edges, "edge", "edges") + " and " +
         count(topology.non_manifold_vertices, "vertex", "vertices") + " are not";
}

std::string intersections(std::int64_t pairs) {
  if (pairs == 0) return "none";
  return count(pairs, "pair of faces", "pairs of faces");
}

void add_holes(Table& table, const std::vector<Hole>& holes) {
  constexpr std::size_t kShown = 10;
  if (holes.empty()) return;
  table.add("holes", std::to_string(holes.size()));
  for (std::size_t i = 0; i < std::min(holes.size(), kShown); ++i) {
    const Hole& hole = holes[i];
    char text[200];
    std::snprintf(text, sizeof text, "diameter %.4g, length %.4g, area %.4g, around %.4g %.4g %.4g",
                  hole.diameter, hole.length, hole.area, hole.centre[0], hole.centre[1], hole.centre[2]);
    table.add(("hole " + std::to_string(i + 1)).c_str(), text);
  }
  if (holes.size() > kShown) table.add("more holes", "--json lists all");
}

/// "12.5 mm²": the unit to the power of `exponent`, as "²".
std::string measured(const std::optional<double>& value, const std::string& unit, const char* exponent) {
  return number_or_dash("%.6g", value) + (unit.empty() || !value ? "" : " " + unit + exponent);
}

void add_extent(Table& table, const Report& report) {
  constexpr std::size_t kMostParts = 10;
  table.add("area", measured(report.area, report.unit, "²"));
  table.add("volume", measured(report.volume, report.unit, "³"));
  if (report.parts.size() > 1)
    for (std::size_t i = 0; i < std::min(report.parts.size(), kMostParts); ++i)
      table.add("component " + std::to_string(i + 1),
                "area " + measured(report.parts[i].area, report.unit, "²") + ", volume " +
                    measured(report.parts[i].volume, report.unit, "³"));
  if (report.parts.size() > kMostParts)
    table.add("components not listed", std::to_string(report.parts.size() - kMostParts));
  if (!report.ground) return;
  const auto volume = [&](double PlaneVolumes::*value) {
    const auto& volumes = report.ground->volumes;
    return measured(volumes ? std::optional((*volumes).*value) : std::nullopt, report.unit, "³");
  };
  table.add("volume above the ground", volume(&PlaneVolumes::above));
  table.add("volume below the ground", volume(&PlaneVolumes::below));
  table.add("volume over ground, net", volume(&PlaneVolumes::net));
}

void add_cloud(Table& table, const CloudFit& cloud, const std::string& unit) {
  table.add("points", std::to_string(cloud.points));
  table.add("points that are vertices", number("%.2f %%", cloud.interpolated));
  table.add("from points to mesh, mean", measured(cloud.distance_mean, unit, ""));
  table.add("from points to mesh, largest", measured(cloud.distance_max, unit, ""));
}

void add_truth(Table& table, const TruthFit& truth) {
  const auto distance = [&](const char* format, double TruthDistances::*value) {
    return truth.distances ? number(format, (*truth.distances).*value) : "-";
  };
  table.add("Chamfer distance x 1000", distance("%.4f", &TruthDistances::chamfer_e3));
  table.add("F-score at 0.005", distance("%.2f %%", &TruthDistances::f_score));
  table.add("normal consistency", distance("%.2f %%", &TruthDistances::normal_consistency));
  table.add("turned over", distance("%.2f %%", &TruthDistances::turned_over));
  table.add("Hausdorff distance", distance("%.6f", &TruthDistances::hausdorff));
  if (truth.sharp.restored)
    table.add("sharp edges restored",
              number("%.2f %%", *truth.sharp.restored) + " of " + std::to_string(truth.sharp.edges));
  table.add("genus right", yes(truth.genus_right));
  table.add("components right", yes(truth.components_right));
  table.add("topology right", yes(truth.topology_right()));
}

using Json = nlohmann::ordered_json;

template <typename Value>
Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

Json hole_list(const std::vector<Hole>& holes) {
  Json list = Json::array();
  for (const Hole& hole : holes)
    list.push_back({{"length", hole.length},
                    {"diameter", hole.diameter},
                    {"area", hole.area},
                    {"centre", hole.centre},
                    {"normal", hole.normal},
                    {"edges", hole.edges}});
  return list;
}

Json component_list(const Report& report) {
  constexpr std::size_t kMostParts = 1000;
  Json list = Json::array();
  for (std::size_t i = 0; i < std::min(report.parts.size(), kMostParts); ++i) {
    const Component& part = report.parts[i];
    list.push_back({{"faces", part.faces},
                    {"closed", part.closed},
                    {"area", part.area},
                    {"volume", or_null(part.volume)}});
  }
  return list;
}

Json ground_members(const GroundFit& ground) {
  const auto& volumes = ground.volumes;
  return {{"ground", {ground.up.x(), ground.up.y(), ground.up.z(), ground.offset}},
          {"volume_above", volumes ? Json(volumes->above) : Json()},
          {"volume_below", volumes ? Json(volumes->below) : Json()},
          {"volume_net", volumes ? Json(volumes->net) : Json()}};
}

Json cloud_members(const CloudFit& cloud) {
  return {{"points", cloud.points},
          {"interpolated", cloud.interpolated},
          {"cloud_distance_mean", or_null(cloud.distance_mean)},
          {"cloud_distance_max", or_null(cloud.distance_max)}};
}

Json truth_members(const TruthFit& truth) {
  const auto distance = [&](double TruthDistances::*value) {
    return truth.distances ? Json((*truth.distances).*value) : Json();
  };
  return {{"chamfer_e3", distance(&TruthDistances::chamfer_e3)},
          {"f_score", distance(&TruthDistances::f_score)},
          {"normal_consistency", distance(&TruthDistances::normal_consistency)},
          {"turned_over", distance(&TruthDistances::turned_over)},
          {"hausdorff", distance(&TruthDistances::hausdorff)},
          {"sharp_edges", truth.sharp.edges},
          {"sharp_edges_restored", or_null(truth.sharp.restored)},
          {"genus_right", truth.genus_right},
          {"components_right", truth.components_right},
          {"topology_right", truth.topology_right()}};
}

}  // namespace

Rows table_rows(const Report& report) {
  const Topology& topology = report.topology;
  Table table;
  table.add("vertices", std::to_string(report.vertices));
  table.add("faces", std::to_string(report.faces));
  table.add("closed", closed(topology));
  table.add("manifold", manifold(topology));
  table.add("faces agree in orientation", yes(topology.oriented));
  table.add("winds outward", yes(report.outward));
  table.add("components", std::to_string(topology.components));
  table.add("genus", topology.genus ? std::to_string(*topology.genus) : "-");
  table.add("self-intersections", intersections(report.self_intersections));
  add_extent(table, report);
  add_holes(table, report.holes);
  if (report.cloud) add_cloud(table, *report.cloud, report.unit);
  if (report.truth) add_truth(table, *report.truth);
  return std::move(table).rows();
}

std::string to_text(const Report& report) {
  const Rows rows = table_rows(report);
  std::size_t width = 0;
  for (const auto& row : rows) width = std::max(width, row.first.size());
  std::string text;
  for (const auto& [name, value] : rows)
    text.append(name).append(width + 2 - name.size(), ' ').append(value).append("\n");
  return text;
}

std::string to_json(const Report& report) {
  const Topology& topology = report.topology;
  Json json = {{"vertices", report.vertices},
               {"faces", report.faces},
               {"boundary_edges", topology.boundary_edges},
               {"non_manifold_edges", topology.non_manifold_edges},
               {"non_manifold_vertices", topology.non_manifold_vertices},
               {"self_intersections", report.self_intersections},
               {"components", topology.components},
               {"genus", or_null(topology.genus)},
               {"closed", topology.closed},
               {"manifold", topology.manifold},
               {"oriented", topology.oriented},
               {"outward", report.outward},
               {"area", report.area},
               {"volume", or_null(report.volume)},
               {"holes", hole_list(report.holes)},
               {"component_list", component_list(report)}};
  if (!report.unit.empty()) json["unit"] = report.unit;
  if (report.ground) json.update(ground_members(*report.ground));
  if (report.cloud) json.update(cloud_members(*report.cloud));
  if (report.truth) json.update(truth_members(*report.truth));
  return json.dump(2) + "\n";
}

}  // namespace filmsticking::mesh_report
