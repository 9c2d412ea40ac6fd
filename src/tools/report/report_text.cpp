// SPDX-License-Identifier: GPL-3.0-or-later
#include <cinttypes>
#include <cstdio>
#include <utility>
#include <vector>

#include "io/json.h"
#include "report.h"

namespace filmsticking::mesh_report {
namespace {

/// Names in one column, what there is to say in the next.
class Table {
 public:
  void add(const char* name, const std::string& value) {
    width_ = std::max(width_, std::string(name).size());
    rows_.emplace_back(name, value);
  }
  std::string text() const {
    std::string text;
    for (const auto& [name, value] : rows_)
      text.append(name).append(width_ + 2 - name.size(), ' ').append(value).append("\n");
    return text;
  }

 private:
  std::size_t width_ = 0;
  std::vector<std::pair<std::string, std::string>> rows_;
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

}  // namespace

std::string to_text(const Report& report) {
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
  table.add("area", number("%.6g", report.area));
  table.add("volume", report.volume ? number("%.6g", *report.volume) : "-");
  if (report.cloud) {
    const CloudFit& cloud = *report.cloud;
    table.add("points", std::to_string(cloud.points));
    table.add("points that are vertices", number("%.2f %%", cloud.interpolated));
    table.add("from points to mesh, mean", cloud.distance_mean ? number("%.6g", *cloud.distance_mean) : "-");
    table.add("from points to mesh, largest", cloud.distance_max ? number("%.6g", *cloud.distance_max) : "-");
  }
  if (report.truth) {
    const TruthFit& truth = *report.truth;
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
  return table.text();
}

std::string to_json(const Report& report) {
  const Topology& topology = report.topology;
  io::JsonObject json;
  json.add("vertices", report.vertices)
      .add("faces", report.faces)
      .add("boundary_edges", topology.boundary_edges)
      .add("non_manifold_edges", topology.non_manifold_edges)
      .add("non_manifold_vertices", topology.non_manifold_vertices)
      .add("self_intersections", report.self_intersections)
      .add("components", topology.components)
      .add("genus", topology.genus)
      .add("closed", topology.closed)
      .add("manifold", topology.manifold)
      .add("oriented", topology.oriented)
      .add("outward", report.outward)
      .add("area", report.area)
      .add("volume", report.volume);
  if (report.cloud)
    json.add("points", report.cloud->points)
        .add("interpolated", report.cloud->interpolated)
        .add("cloud_distance_mean", report.cloud->distance_mean)
        .add("cloud_distance_max", report.cloud->distance_max);
  if (report.truth) {
    const auto distance = [&](double TruthDistances::*value) {
      const auto& distances = report.truth->distances;
      return distances ? std::optional<double>((*distances).*value) : std::nullopt;
    };
    json.add("chamfer_e3", distance(&TruthDistances::chamfer_e3))
        .add("f_score", distance(&TruthDistances::f_score))
        .add("normal_consistency", distance(&TruthDistances::normal_consistency))
        .add("turned_over", distance(&TruthDistances::turned_over))
        .add("hausdorff", distance(&TruthDistances::hausdorff))
        .add("sharp_edges", report.truth->sharp.edges)
        .add("sharp_edges_restored", report.truth->sharp.restored)
        .add("genus_right", report.truth->genus_right)
        .add("components_right", report.truth->components_right)
        .add("topology_right", report.truth->topology_right());
  }
  return json.lines();
}

}  // namespace filmsticking::mesh_report
