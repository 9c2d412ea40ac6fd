// SPDX-License-Identifier: GPL-3.0-or-later
#include "topology.h"

#include <algorithm>
#include <vector>

#include "disjoint_sets.h"
#include "sides.h"

namespace filmsticking::mesh_report {
namespace {

/// The corner of the side's face at one of the edge's ends, as 3 * face + corner.
std::size_t corner_at_low(const Side& side) {
  return 3 * std::size_t(side.face) + (side.forward ? side.corner : (side.corner + 1) % 3);
}
std::size_t corner_at_high(const Side& side) {
  return 3 * std::size_t(side.face) + (side.forward ? (side.corner + 1) % 3 : side.corner);
}

}  // namespace

Topology topology(const Surface& surface) {
  Topology result;
  const std::size_t vertices = surface.positions.size(), faces = surface.triangles.size();
  if (faces == 0) return result;

  const std::vector<Side> sides = sides_by_edge(surface);
  DisjointSets pieces(vertices);
  DisjointSets fans(3 * faces);    // corners joined where their faces share an edge
  DisjointSets covers(2 * faces);  // the front (2f) and the back (2f + 1) of face f
  std::vector<char> bad(vertices, 0);
  std::int64_t disagreeing = 0;
  for (auto begin = sides.begin(); begin != sides.end();) {
    const auto end =
        std::find_if(begin, sides.end(), [&](const Side& side) { return !side.same_edge(*begin); });
    ++result.edges;
    pieces.join(begin->low, begin->high);
    for (auto side = begin + 1; side != end; ++side) {
      fans.join(corner_at_low(*begin), corner_at_low(*side));
      fans.join(corner_at_high(*begin), corner_at_high(*side));
    }
    const auto faces_here = end - begin;
    if (faces_here == 1) {
      ++result.boundary_edges;
    } else if (faces_here == 2) {
      const bool agree = begin->forward != begin[1].forward;
      if (!agree) ++disagreeing;
      const std::size_t one = 2 * std::size_t(begin->face), other = 2 * std::size_t(begin[1].face);
      covers.join(one, agree ? other : other + 1);
      covers.join(one + 1, agree ? other + 1 : other);
    } else {
      ++result.non_manifold_edges;
      bad[begin->low] = bad[begin->high] = 1;
    }
    begin = end;
  }

  std::vector<char> has_fan(vertices, 0);
  for (std::size_t corner = 0; corner < 3 * faces; ++corner) {
    if (fans.find(corner) != corner) continue;
    const std::int32_t v = surface.triangles[corner / 3][corner % 3];
    if (has_fan[v]) bad[v] = 1;
    has_fan[v] = 1;
  }
  result.non_manifold_vertices = std::count(bad.begin(), bad.end(), 1);
  for (std::size_t v = 0; v < vertices; ++v) result.components += pieces.find(v) == v;

  result.closed = result.boundary_edges == 0;
  result.manifold = result.non_manifold_edges == 0 && result.non_manifold_vertices == 0;
  result.oriented = disagreeing == 0 && result.non_manifold_edges == 0;
  bool two_sided = true;
  for (std::size_t f = 0; f < faces && two_sided; ++f)
    two_sided = covers.find(2 * f) != covers.find(2 * f + 1);
  if (result.closed && result.manifold && two_sided) {
    const std::int64_t euler = std::int64_t(vertices) - result.edges + std::int64_t(faces);
    result.genus = result.components - euler / 2;
  }
  return result;
}

}  // namespace filmsticking::mesh_report
