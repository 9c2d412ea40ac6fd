// SPDX-License-Identifier: GPL-3.0-or-later
// What the library promises about a mesh, checked from scratch.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "filmsticking/types.h"

namespace filmsticking::test {

/// Six times the volume that the triangles enclose; positive when they wind outward.
inline double signed_volume(const Mesh& mesh) {
  double sum = 0;
  if (mesh.positions.empty()) return sum;
  const auto from_first = [&](int vertex) {  // large coordinates would swamp the sum
    Point p = mesh.positions[vertex];
    for (int k = 0; k < 3; ++k) p[k] -= mesh.positions[0][k];
    return p;
  };
  for (const Triangle& t : mesh.triangles) {
    const Point a = from_first(t[0]), b = from_first(t[1]), c = from_first(t[2]);
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum;
}

/// Empty for a consistently oriented 2-manifold that uses every vertex, closed unless it may be `open`; else
/// what is wrong.
inline std::string surface_fault(const Mesh& mesh, bool open = false) {
  if (mesh.triangles.empty()) return "no triangles";
  std::map<std::pair<int, int>, int> apex;                      // directed edge -> the face's third corner
  std::vector<std::map<int, int>> ring(mesh.positions.size());  // corner -> next corner around a vertex
  for (const Triangle& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
      if (a < 0 || static_cast<std::size_t>(a) >= mesh.positions.size()) return "index out of range";
      if (a == b) return "a triangle repeats a vertex";
      if (!apex.emplace(std::pair(a, b), c).second) return "an edge has two faces on one side";
      ring[a][b] = c;
    }
  }
  for (const auto& [edge, corner] : apex)
    if (!open && !apex.count({edge.second, edge.first})) return "an edge has one face only";
  for (const auto& next : ring) {
    if (next.empty()) return "a vertex without faces";
    std::size_t length = 0;
    int first = next.begin()->first;
    std::set<int> into;  // a fan starts where nothing leads to
    for (const auto& [from, to] : next) into.insert(to);
    for (const auto& [from, to] : next)
      if (!into.count(from)) first = from;
    int corner = first;
    do {
      corner = next.at(corner);
      ++length;
    } while (corner != first && next.count(corner) && length <= next.size());
    if (length != next.size()) return "the faces around a vertex are not one ring or fan";
  }
  if (std::set<Point>(mesh.positions.begin(), mesh.positions.end()).size() != mesh.positions.size())
    return "two vertices at one place";
  return "";
}

}  // namespace filmsticking::test
