// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/restricted_power_diagram.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "geometry/parallel.h"

namespace filmsticking {
namespace {

// A walk that has visited more neighbours per site than this sorts the sites instead.
constexpr std::int64_t kManyLooks = 16;

// Appends the cells along a segment, starting with a's, by all sites. Along the segment each site's power is
// linear, up to a term common to all, so the cells are the lower envelope of lines. Found in the order of
// slopes, as a convex hull (Andrew 1979).
void envelope(const PowerDiagram& diagram, const Vec3& from, const Vec3& direction, Index a,
              std::vector<Index>& cells) {
  struct Line {
    double height, power;
    Index site;
    double meets(const Line& other) const { return (other.power - power) / (2 * (other.height - height)); }
  };
  const auto line = [&](Index i) {
    return Line{direction.dot(diagram.position[i]), diagram.power(i, from), i};
  };
  std::vector<Line> higher, chain{line(a)};
  for (Index i = 0; i < static_cast<Index>(diagram.position.size()); ++i)
    if (const Line own = line(i); own.height > chain[0].height && diagram.has_cell(i)) higher.push_back(own);
  std::sort(higher.begin(), higher.end(), [](const Line& l, const Line& m) {
    return std::tie(l.height, l.power, l.site) < std::tie(m.height, m.power, m.site);
  });
  for (const Line& next : higher) {
    if (next.height == chain.back().height) continue;
    while (chain.size() > 1 && chain.back().meets(next) <= chain[chain.size() - 2].meets(chain.back()))
      chain.pop_back();
    if (chain.back().meets(next) < 1) chain.push_back(next);
  }
  for (const Line& one : chain) cells.push_back(one.site);
}

struct WalkCounts {
  std::int64_t jumps = 0, looks = 0;
};

// Appends the cells from `a` (the owner of `from`) to `b` (the owner of `to`) along a segment.
void walk(const PowerDiagram& diagram, const Vec3& from, const Vec3& to, Index a, Index b,
          std::vector<Index>& cells, WalkCounts& counts) {
  const Vec3 direction = to - from;
  const auto start = static_cast<std::ptrdiff_t>(cells.size());
  const std::int64_t most = counts.looks + kManyLooks * static_cast<std::int64_t>(diagram.position.size());
  cells.push_back(a);
  Index at = a;
  // Ends: along a line the cells have rising direction.p, so every move raises it.
  double height = direction.dot(diagram.position[at]);
  while (at != b && counts.looks <= most) {
    const double here = diagram.power(at, from);
    Index next = kNone;
    double first = 1, next_height = 0;
    counts.looks += diagram.offset[at + 1] - diagram.offset[at];
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
  if (counts.looks > most && at != b) {
    cells.resize(static_cast<std::size_t>(start));
    envelope(diagram, from, direction, a, cells);
    const auto end = std::find(cells.begin() + start, cells.end(), b);
    if (end != cells.end()) cells.erase(end + 1, cells.end());
    at = cells.back();
  }
  // Rounding may end the walk one cell before the end's owner.
  if (at != b) cells.push_back(b), ++counts.jumps;
}

}  // namespace

RestrictedPowerDiagram restrict_power_diagram(const Surface& surface, std::vector<Index> twin,
                                              const PowerDiagram& diagram) {
  RestrictedPowerDiagram restricted;
  restricted.twin = std::move(twin);

  // Owners of the vertices. The search starts at the vertex's own site, else at the owner of the vertex
  // before, which is near if vertices are ordered by neighbourhood. Chunks make the hints independent of the
  // threads.
  const std::size_t vertices = surface.positions.size();
  std::vector<Index> owner(vertices);
  parallel_chunks(vertices, 1024, [&](std::size_t, std::size_t begin, std::size_t end) {
    Index hint = kNone;
    for (std::size_t v = begin; v < end; ++v) {
      // A hint must have a cell. Removed and hidden sites have none.
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
  std::vector<WalkCounts> counts(cells.size());
  restricted.offset.assign(leader.size() + 1, 0);
  parallel_chunks(leader.size(), kChunk, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      const Corners& t = surface.triangles[leader[e] / 3];
      const Index u = t[leader[e] % 3], v = t[(leader[e] + 1) % 3 == 0 ? 0 : leader[e] % 3 + 1];
      const std::size_t before = cells[chunk].size();
      walk(diagram, surface.positions[u], surface.positions[v], owner[u], owner[v], cells[chunk],
           counts[chunk]);
      restricted.offset[e + 1] = static_cast<Index>(cells[chunk].size() - before);
    }
  });
  for (std::size_t e = 1; e < restricted.offset.size(); ++e) restricted.offset[e] += restricted.offset[e - 1];
  for (const WalkCounts& part : counts) restricted.jumps += part.jumps, restricted.looks += part.looks;
  restricted.cell.reserve(restricted.offset.back());
  for (const auto& part : cells) restricted.cell.insert(restricted.cell.end(), part.begin(), part.end());
  return restricted;
}

}  // namespace filmsticking
