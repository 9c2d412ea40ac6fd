// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay/tetrahedral_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/parallel.h"

namespace filmsticking {
namespace {

// Relative to the first corner, to keep the digits of small tetrahedra.
Vec3 circumcentre(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = b - a, v = c - a, w = d - a;
  const Vec3 vw = v.cross(w);
  const double volume6 = u.dot(vw);
  if (volume6 == 0) return (a + b + c + d) / 4;
  return a +
         (u.squaredNorm() * vw + v.squaredNorm() * w.cross(u) + w.squaredNorm() * u.cross(v)) / (2 * volume6);
}

// The facets on the side of the largest facet, as bits, if the tetrahedron is thinner than kFlat; else 0.
std::uint8_t flat_side(const std::array<Vec3, 4>& p) {
  const Vec3 u = p[1] - p[0], v = p[2] - p[0], w = p[3] - p[0];
  const double volume6 = std::abs(u.dot(v.cross(w)));
  const double square = std::max({u.squaredNorm(), v.squaredNorm(), w.squaredNorm()});
  if (volume6 > kFlat * 4 * square) return 0;  // no edge is longer than twice the longest of u, v, w
  std::array<Vec3, 4> normal;
  int largest = 0;
  for (int k = 0; k < 4; ++k) {
    const Vec3& o = p[kFacet[k][0]];
    normal[k] = (p[kFacet[k][1]] - o).cross(p[kFacet[k][2]] - o);
    if (normal[k].squaredNorm() > normal[largest].squaredNorm()) largest = k;
  }
  if (volume6 > kFlat * normal[largest].norm()) return 0;
  int side = 0;
  for (int k = 0; k < 4; ++k) side |= (normal[k].dot(normal[largest]) > 0 ? 1 : 0) << k;
  return static_cast<std::uint8_t>(side);
}

int corner_index(const std::array<Index, 4>& corners, Index v) {
  for (int k = 0; k < 4; ++k)
    if (corners[k] == v) return k;
  return -1;
}

}  // namespace

TetrahedralMesh make_tetrahedral_mesh(Tetrahedra tets, const std::vector<Vec3>& sites) {
  TetrahedralMesh mesh;
  mesh.tets = std::move(tets);
  const std::size_t n = mesh.tets.size();
  mesh.mirror.resize(n);
  mesh.circumcentre.resize(n);
  mesh.circumradius.resize(n);
  mesh.flat.resize(n);
  parallel_each(n, [&](std::size_t t) {
    const auto& corners = mesh.tets.corners[t];
    for (int k = 0; k < 4; ++k) {
      // Two infinite tetrahedra of a flat cloud may share several facets. So compare the back pointer and the
      // corner that is not shared.
      const Index u = mesh.tets.neighbours[t][k];
      int facet = 0;
      for (int j = 0; j < 4; ++j)
        if (mesh.tets.neighbours[u][j] == static_cast<Index>(t) &&
            corner_index(corners, mesh.tets.corners[u][j]) < 0)
          facet = j;
      mesh.mirror[t][k] = 4 * u + facet;
    }
    const int infinite = corner_index(corners, kNone);
    if (infinite >= 0) {
      const Vec3 &a = sites[corners[kFacet[infinite][0]]], &b = sites[corners[kFacet[infinite][1]]],
                 &c = sites[corners[kFacet[infinite][2]]];
      mesh.circumcentre[t] = (b - a).cross(c - a).normalized();
      mesh.circumradius[t] = std::numeric_limits<double>::infinity();
      mesh.flat[t] = 0;
    } else {
      const std::array<Vec3, 4> p = {sites[corners[0]], sites[corners[1]], sites[corners[2]],
                                     sites[corners[3]]};
      mesh.circumcentre[t] = circumcentre(p[0], p[1], p[2], p[3]);
      mesh.flat[t] = flat_side(p);
      mesh.circumradius[t] = (mesh.circumcentre[t] - sites[corners[0]]).norm();
    }
  });
  return mesh;
}

std::vector<Corners> tetrahedral_boundary(const TetrahedralMesh& mesh, const std::vector<char>& inside) {
  constexpr std::size_t kChunk = 16384;
  std::vector<std::vector<Corners>> parts((mesh.size() + kChunk - 1) / kChunk);
  parallel_chunks(mesh.size(), kChunk, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      if (!inside[t]) continue;
      const auto& c = mesh.tets.corners[t];
      for (int k = 0; k < 4; ++k)
        if (const Corners f{c[kFacet[k][0]], c[kFacet[k][1]], c[kFacet[k][2]]};
            !inside[mesh.tets.neighbours[t][k]] && std::count(f.begin(), f.end(), kNone) == 0)
          parts[chunk].push_back(f);
    }
  });
  std::vector<Corners> boundary;
  for (const auto& part : parts) boundary.insert(boundary.end(), part.begin(), part.end());
  return boundary;
}

}  // namespace filmsticking
