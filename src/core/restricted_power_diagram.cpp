// SPDX-License-Identifier: GPL-3.0-or-later
#include "restricted_power_diagram.h"

#include <numeric>
#include <utility>

#include "parallel.h"

namespace filmsticking {
namespace {

// Appends the cells from `a` (the owner of `from`) to `b` (the owner of `to`) along a segment. Returns whether it
// had to jump.
bool walk(const PowerDiagram& diagram, const Vec3& from, const Vec3& to, Index a, Index b,
          std::vector<Index>& cells) {
  const Vec3 direction = to - from;
  cells.push_back(a);
  Index at = a;
  // Along a line, the cells come in the order of direction.p: every move raises it, so the walk ends.
  double height = direction.dot(diagram.position[at]);
  while (at != b) {
    const double here = diagram.power(at, from);
    Index next = kNone;
    double first = 1, next_height = 0;
    for (Index k = diagram.offset[at]; k < diagram.offset[at + 1]; ++k) {
      const Index j = diagram.neighbour[k];
      const double h = direction.dot(diagram.position[j]);
      if (!(h > height)) continue;
      const double t = (diagram.power(j, from) - here) / (2 * (h - height));
      if (t < first) first = t, next = j, next_height = h;
    }
    if (next == kNone) break;
    at = next, height = next_height;
    cells.push_back(at);
  }
  // Rounding may have the walk stop one cell short of the owner that was found for the vertex.
  if (at != b) cells.push_back(b);
  return at != b;
}

}  // namespace

RestrictedPowerDiagram restrict_power_diagram(const GuidingSurface& surface, std::vector<Index> twin,
                                              const PowerDiagram& diagram) {
  RestrictedPowerDiagram restricted;
  restricted.twin = std::move(twin);

  // Owners of the vertices. A vertex that is a site starts there; the others from the one before, which is
  // near where the surface was written by a walk over it. Chunks make the hints independent of the threads.
  const std::size_t vertices = surface.positions.size();
  std::vector<Index> owner(vertices);
  parallel_chunks(vertices, 1024, [&](std::size_t, std::size_t begin, std::size_t end) {
    Index hint = kNone;
    for (std::size_t v = begin; v < end; ++v) {
      // A hint must have a cell; a site that left the diagram or is hidden has none.
      if (surface.site[v] != kNone && diagram.has_cell(surface.site[v])) hint = surface.site[v];
      owner[v] = hint = diagram.owner(surface.positions[v], hint);
    }
  });

  std::vector<Index> leader;  // the half-edge along each edge's direction
  restricted.edge.assign(restricted.twin.size(), kNone);
  restricted.forward.assign(restricted.twin.size(), 0);
  for (Index h = 0; h < static_cast<Index>(restricted.twin.size()); ++h) {
    if (restricted.edge[h] != kNone) continue;
    restricted.edge[h] = restricted.edge[restricted.twin[h]] = static_cast<Index>(leader.size());
    restricted.forward[h] = 1;
    leader.push_back(h);
  }

  constexpr std::size_t kChunk = 2048;
  std::vector<std::vector<Index>> cells((leader.size() + kChunk - 1) / kChunk);
  std::vector<std::int64_t> jumps(cells.size(), 0);
  restricted.offset.assign(leader.size() + 1, 0);
  parallel_chunks(leader.size(), kChunk, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      const Corners& t = surface.triangles[leader[e] / 3];
      const Index u = t[leader[e] % 3], v = t[(leader[e] + 1) % 3 == 0 ? 0 : leader[e] % 3 + 1];
      const std::size_t before = cells[chunk].size();
      jumps[chunk] +=
          walk(diagram, surface.positions[u], surface.positions[v], owner[u], owner[v], cells[chunk]);
      restricted.offset[e + 1] = static_cast<Index>(cells[chunk].size() - before);
    }
  });
  for (std::size_t e = 1; e < restricted.offset.size(); ++e) restricted.offset[e] += restricted.offset[e - 1];
  restricted.jumps = std::accumulate(jumps.begin(), jumps.end(), std::int64_t{0});
  restricted.cell.reserve(restricted.offset.back());
  for (const auto& part : cells) restricted.cell.insert(restricted.cell.end(), part.begin(), part.end());
  return restricted;
}

}  // namespace filmsticking
