// SPDX-License-Identifier: GPL-3.0-or-later
// ManifoldLabels: cavities whose mouths are barred.
#include <algorithm>
#include <cstddef>

#include "labelling/manifold_labels.h"

namespace filmsticking {
namespace {

// Circumradii, in the largest spacing of the corners, from which facets are taken to span a mouth and not to
// line it, the widest first: facets between random samples of a surface have up to two.
constexpr double kBarRadii[] = {3, 2.5, 2, 1.75, 1.5, 1.25, 1};
// A larger part of the inside bars no narrow mouth.
constexpr std::size_t kLargestBar = 3000;

}  // namespace

// Parts of the inside connected through wide facets that lie between pieces of the outside, in rising order
// of size.
std::vector<ManifoldLabels::Move> ManifoldLabels::bars(const std::vector<Vec3>& sites, double radius) {
  // Of an open surface infinite tetrahedra may be inside; none bars anything.
  const auto in = [&](Index t) { return inside_[t] && !mesh_.tets.infinite(t); };
  std::vector<char> met(mesh_.size(), 0);
  std::vector<Move> parts;
  std::vector<Index> around;
  for (std::size_t s = 0; s < mesh_.size(); ++s) {
    if (met[s] || !in(static_cast<Index>(s))) continue;
    met[s] = 1;
    Move part{static_cast<Index>(s)};
    around.clear();
    for (std::size_t i = 0; i < part.size(); ++i)
      for (int k = 0; k < 4; ++k) {
        const Index u = mesh_.tets.neighbours[part[i]][k];
        if (!inside_[u]) {
          if (around.empty() || around.back() != piece(u)) around.push_back(piece(u));
        } else if (!met[u] && in(u) && !narrow_facet(sites, part[i], k, radius)) {
          met[u] = 1, part.push_back(u);
        }
      }
    unique_sorted(around);
    if (around.size() >= 2 && part.size() <= kLargestBar) parts.push_back(std::move(part));
  }
  return smallest_first(std::move(parts));
}

void ManifoldLabels::open_cavities(const std::vector<Vec3>& sites) {
  if (name_pieces() < 3) return;
  for (const double radius : kBarRadii)
    if (!spent()) fill_all(bars(sites, radius), 1, {kTunnelWorth, kTearWorth, 0, true});
}

}  // namespace filmsticking
