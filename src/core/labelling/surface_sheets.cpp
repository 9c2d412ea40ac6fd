// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/surface_sheets.h"

#include <atomic>

#include "geometry/parallel.h"

namespace filmsticking {
namespace {

// A facet at a site: its other two corners, counter-clockwise from outside. The infinite vertex counts as any
// other.
struct Corner {
  Index from, to;
};

// Calls visit(site, corner) for the corners of the facets between the labels, from several threads.
template <class Visit>
void each_corner(const TetrahedralMesh& mesh, const std::vector<char>& inside, const Visit& visit) {
  parallel_each(mesh.size(), [&](std::size_t t) {
    if (!inside[t]) return;
    const auto& c = mesh.tets.corners[t];
    for (int k = 0; k < 4; ++k) {
      if (inside[mesh.tets.neighbours[t][k]]) continue;
      for (int j = 0; j < 3; ++j)
        if (const Index v = c[kFacet[k][j]]; v != kNone)
          visit(v, Corner{c[kFacet[k][(j + 1) % 3]], c[kFacet[k][(j + 2) % 3]]});
    }
  });
}

// On a small sphere around the site the corners are arcs. Do they form one simple closed curve?
bool one_curve(const Corner* begin, const Corner* end) {
  Index at = begin->from;
  std::ptrdiff_t length = 0;
  do {
    const Corner* next = nullptr;
    for (const Corner* c = begin; c != end; ++c) {
      if (c->from != at) continue;
      if (next != nullptr) return false;
      next = c;
    }
    if (next == nullptr) return false;
    at = next->to;
    ++length;
  } while (at != begin->from && length <= end - begin);
  return length == end - begin;
}

// With more facets the answer is Other: one_curve() takes the square of their number.
constexpr Index kManyFacets = 64;

}  // namespace

std::vector<Sheets> surface_sheets(const TetrahedralMesh& mesh, const std::vector<char>& inside,
                                   std::size_t sites) {
  // A counting sort by site; the order within a site does not matter.
  std::vector<std::atomic<Index>> fill(sites);
  parallel_each(sites, [&](std::size_t v) { fill[v].store(0, std::memory_order_relaxed); });
  each_corner(mesh, inside, [&](Index v, Corner) { fill[v].fetch_add(1, std::memory_order_relaxed); });
  std::vector<Index> offset(sites + 1, 0);
  for (std::size_t v = 0; v < sites; ++v) {
    offset[v + 1] = offset[v] + fill[v].load(std::memory_order_relaxed);
    fill[v].store(offset[v], std::memory_order_relaxed);
  }
  std::vector<Corner> corners(static_cast<std::size_t>(offset.back()));
  each_corner(mesh, inside, [&](Index v, Corner c) {
    corners[static_cast<std::size_t>(fill[v].fetch_add(1, std::memory_order_relaxed))] = c;
  });
  std::vector<Sheets> sheets(sites);
  parallel_each(sites, [&](std::size_t v) {
    const Index count = offset[v + 1] - offset[v];
    const Corner* begin = corners.data() + offset[v];
    sheets[v] = count == 0                                                ? Sheets::None
                : count <= kManyFacets && one_curve(begin, begin + count) ? Sheets::Disc
                                                                          : Sheets::Other;
  });
  return sheets;
}

}  // namespace filmsticking
