// SPDX-License-Identifier: GPL-3.0-or-later
#include "carve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "parallel.h"

namespace filmsticking {
namespace {

// Radius of the smallest empty ball through the facet's corners: the width of the gate.
double gate_width(const TetrahedralMesh& mesh, const std::vector<Vec3>& sites,
                  const std::vector<double>& spacing, Index t, int k) {
  const auto& corners = mesh.tets.corners[t];
  const Index i = corners[kFacet[k][0]], j = corners[kFacet[k][1]], l = corners[kFacet[k][2]];
  if (i == kNone || j == kNone || l == kNone) return std::numeric_limits<double>::infinity();
  const Vec3 &a = sites[i], &b = sites[j], &c = sites[l];
  const Vec3 normal = (b - a).cross(c - a);  // out of t
  const Index u = mesh.tets.neighbours[t][k];
  const bool infinite_t = mesh.tets.infinite(t), infinite_u = mesh.tets.infinite(u);
  const bool own_side_t = infinite_t || normal.dot(mesh.circumcentre[t] - a) <= 0;
  const bool own_side_u = infinite_u || normal.dot(mesh.circumcentre[u] - a) >= 0;
  double radius = std::min(mesh.circumradius[t], mesh.circumradius[u]);
  if (own_side_t && own_side_u) {
    const double area2 = normal.squaredNorm();
    if (area2 > 0)
      radius = std::sqrt((b - c).squaredNorm() * (c - a).squaredNorm() * (a - b).squaredNorm() / (4 * area2));
  }
  // The largest of the corners' spacings: a coarse region's gates must not look wide beside a fine one.
  return radius / std::max({spacing[i], spacing[j], spacing[l], 1e-300});
}

}  // namespace

std::vector<double> carve_widths(const TetrahedralMesh& mesh, const std::vector<Vec3>& sites,
                                 const std::vector<double>& spacing) {
  std::vector<std::array<double, 4>> gate(mesh.size());
  parallel_each(mesh.size(), [&](std::size_t t) {
    for (int k = 0; k < 4; ++k) gate[t][k] = gate_width(mesh, sites, spacing, static_cast<Index>(t), k);
  });
  // Widest paths from infinity, by Dijkstra's order.
  std::vector<double> width(mesh.size(), 0);
  std::priority_queue<std::pair<double, Index>> front;
  for (std::size_t t = 0; t < mesh.size(); ++t)
    if (mesh.tets.infinite(static_cast<Index>(t))) {
      width[t] = std::numeric_limits<double>::infinity();
      front.emplace(width[t], static_cast<Index>(t));
    }
  while (!front.empty()) {
    const auto [w, t] = front.top();
    front.pop();
    if (w < width[t]) continue;
    for (int k = 0; k < 4; ++k) {
      const Index u = mesh.tets.neighbours[t][k];
      const double through = std::min(w, gate[t][k]);
      if (through > width[u]) width[u] = through, front.emplace(through, u);
    }
  }
  return width;
}

}  // namespace filmsticking
