// SPDX-License-Identifier: GPL-3.0-or-later
#include "evidence/ball.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "geometry/parallel.h"
#include "geometry/triangle_circle.h"

namespace filmsticking {
double facet_width(const TetrahedralMesh& mesh, const std::vector<Vec3>& sites,
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
    if (normal.squaredNorm() > 0) radius = std::sqrt(circumradius2(a, b, c));
  }
  return radius / std::max({spacing[i], spacing[j], spacing[l], 1e-300});
}

std::vector<double> ball_widths(const TetrahedralMesh& mesh, const std::vector<Vec3>& sites,
                                const std::vector<double>& spacing, double least, double most) {
  least = static_cast<float>(least), most = static_cast<float>(most);  // the precision of `gate`
  UnsetVector<std::array<float, 4>> gate(mesh.size());
  parallel_each(mesh.size(), [&](std::size_t t) {
    for (int k = 0; k < 4; ++k)
      if (mesh.mirror[t][k] > static_cast<Index>(4 * t) + k)
        gate[t][k] = static_cast<float>(
            std::clamp(facet_width(mesh, sites, spacing, static_cast<Index>(t), k), least, most));
  });
  parallel_each(mesh.size(), [&](std::size_t t) {
    for (int k = 0; k < 4; ++k)
      if (const Index m = mesh.mirror[t][k]; m < static_cast<Index>(4 * t) + k)
        gate[t][k] = gate[m / 4][m % 4];
  });
  // Widest paths from infinity in Dijkstra's order. Tetrahedra of the largest width need no order.
  std::vector<double> width(mesh.size(), least);
  std::vector<Index> widest;
  std::priority_queue<std::pair<double, Index>> front;
  for (std::size_t t = 0; t < mesh.size(); ++t)
    if (mesh.tets.infinite(static_cast<Index>(t))) width[t] = most, widest.push_back(static_cast<Index>(t));
  const auto leave = [&](Index t) {
    for (int k = 0; k < 4; ++k) {
      const Index u = mesh.tets.neighbours[t][k];
      const double through = std::min<double>(width[t], gate[t][k]);
      if (!(through > width[u])) continue;
      width[u] = through;
      if (through == most) {
        widest.push_back(u);
      } else {
        front.emplace(through, u);
      }
    }
  };
  // Ends: a tetrahedron enters when its width rises, and widths are those of finitely many facets.
  while (!widest.empty() || !front.empty()) {
    Index t;
    if (!widest.empty()) {
      t = widest.back();
      widest.pop_back();
    } else {
      const auto [w, next] = front.top();
      front.pop();
      if (w < width[next]) continue;
      t = next;
    }
    leave(t);
  }
  return width;
}

}  // namespace filmsticking
