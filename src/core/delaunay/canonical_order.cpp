// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay/canonical_order.h"

#include <algorithm>
#include <array>
#include <utility>

#include "geometry/parallel.h"

namespace filmsticking {
namespace {

// kNone ranks last.
std::uint32_t rank(Index v) { return static_cast<std::uint32_t>(v); }

// Sorts the corners, and the neighbours with them. Keeps the orientation.
void turn_canonical(std::array<Index, 4>& corners, std::array<Index, 4>& neighbours) {
  bool odd = false;
  const auto sort_pair = [&](int i, int j) {
    if (rank(corners[i]) < rank(corners[j])) return;
    std::swap(corners[i], corners[j]), std::swap(neighbours[i], neighbours[j]);
    odd = !odd;
  };
  sort_pair(0, 1), sort_pair(2, 3), sort_pair(0, 2), sort_pair(1, 3), sort_pair(1, 2);
  if (odd) std::swap(corners[2], corners[3]), std::swap(neighbours[2], neighbours[3]);
}

}  // namespace

Tetrahedra in_canonical_order(Tetrahedra tets, std::size_t sites) {
  const std::size_t n = tets.size();
  parallel_each(n, [&](std::size_t t) { turn_canonical(tets.corners[t], tets.neighbours[t]); });
  // Counting sort by the first corner, then a sort among the few tetrahedra of each.
  std::vector<Index> offset(sites + 1, 0);
  UnsetVector<Index> order(n), place(n);
  for (const auto& c : tets.corners) ++offset[c[0] + 1];
  for (std::size_t v = 1; v < offset.size(); ++v) offset[v] += offset[v - 1];
  {
    std::vector<Index> fill(offset.begin(), offset.end() - 1);
    for (std::size_t t = 0; t < n; ++t) order[fill[tets.corners[t][0]]++] = static_cast<Index>(t);
  }
  const auto key = [&](Index t) {
    const auto& c = tets.corners[t];
    return std::array<std::uint32_t, 3>{rank(c[1]), rank(c[2]), rank(c[3])};
  };
  parallel_each(sites, [&](std::size_t v) {
    std::sort(order.begin() + offset[v], order.begin() + offset[v + 1],
              [&](Index a, Index b) { return key(a) < key(b); });
    for (Index k = offset[v]; k < offset[v + 1]; ++k) place[order[k]] = k;
  });
  Tetrahedra sorted;
  sorted.corners.resize(n);
  parallel_each(n, [&](std::size_t t) { sorted.corners[t] = tets.corners[order[t]]; });
  decltype(tets.corners)().swap(tets.corners);
  sorted.neighbours.resize(n);
  parallel_each(n, [&](std::size_t t) {
    for (int k = 0; k < 4; ++k) sorted.neighbours[t][k] = place[tets.neighbours[order[t]][k]];
  });
  return sorted;
}

}  // namespace filmsticking
