// SPDX-License-Identifier: GPL-3.0-or-later
#include "sharp_edges.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace filmsticking::mesh_report {
namespace {

using Edge = std::pair<std::int32_t, std::int32_t>;

Edge edge_of(std::int32_t a, std::int32_t b) { return {std::min(a, b), std::max(a, b)}; }

std::array<float, 3> place(const Vec3& p) {  // -0 is 0
  return {static_cast<float>(p.x()) + 0.0F, static_cast<float>(p.y()) + 0.0F,
          static_cast<float>(p.z()) + 0.0F};
}

bool bent(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) > kSharp * M_PI / 180;
}

}  // namespace

SharpEdges sharp_edges(const Surface& mesh, const Surface& truth) {
  std::map<std::array<float, 3>, std::int32_t> vertex_at;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    vertex_at.emplace(place(mesh.positions[v]), static_cast<std::int32_t>(v));
  std::set<Edge> edges;
  for (const Triangle& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) edges.insert(edge_of(t[k], t[(k + 1) % 3]));
  std::vector<std::int32_t> vertex_of(truth.positions.size(), -1);
  for (std::size_t v = 0; v < truth.positions.size(); ++v) {
    const auto found = vertex_at.find(place(truth.positions[v]));
    if (found != vertex_at.end()) vertex_of[v] = found->second;
  }

  std::map<Edge, std::vector<Vec3>> area_vectors;  // of the faces at each edge of the truth
  for (std::size_t f = 0; f < truth.triangles.size(); ++f) {
    const Triangle& t = truth.triangles[f];
    for (int k = 0; k < 3; ++k) {
      // As the face sees its edge run: neighbours that agree in orientation see it run the other way.
      const bool forth = t[k] < t[(k + 1) % 3];
      area_vectors[edge_of(t[k], t[(k + 1) % 3])].push_back(truth.area_vector2(f) * (forth ? 1 : -1));
    }
  }
  SharpEdges sharp;
  std::int64_t restored = 0;
  for (const auto& [edge, faces] : area_vectors) {
    const std::int32_t a = vertex_of[edge.first], b = vertex_of[edge.second];
    if (faces.size() != 2 || a < 0 || b < 0 || a == b) continue;
    if (faces[0].isZero(0) || faces[1].isZero(0) || !bent(faces[0], -faces[1])) continue;
    ++sharp.edges;
    restored += edges.count(edge_of(a, b)) > 0 ? 1 : 0;
  }
  if (sharp.edges > 0)
    sharp.restored = 100 * static_cast<double>(restored) / static_cast<double>(sharp.edges);
  return sharp;
}

}  // namespace filmsticking::mesh_report
