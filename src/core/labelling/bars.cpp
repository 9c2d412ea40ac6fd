// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/bars.h"

#include <cstddef>
#include <utility>

#include "labelling/narrow.h"

namespace filmsticking {
namespace {

// A larger part of the inside bars no narrow mouth.
constexpr std::size_t kLargestBar = 3000;

}  // namespace

std::vector<Move> bars(const Labelling& labelling, PieceNames& pieces, const std::vector<Vec3>& sites,
                       double radius) {
  // Of an open surface infinite tetrahedra may be inside; none bars anything.
  const auto in = [&](Index t) { return labelling.label(t) && !labelling.infinite(t); };
  const std::size_t n = labelling.mesh().size();
  std::vector<char> met(n, 0);
  std::vector<Move> parts;
  std::vector<Index> around;
  for (std::size_t s = 0; s < n; ++s) {
    if (met[s] || !in(static_cast<Index>(s))) continue;
    met[s] = 1;
    Move part{static_cast<Index>(s)};
    around.clear();
    for (std::size_t i = 0; i < part.size(); ++i)
      for (int k = 0; k < 4; ++k) {
        const Index u = labelling.neighbours(part[i])[k];
        if (!labelling.label(u)) {
          if (around.empty() || around.back() != pieces.of(u)) around.push_back(pieces.of(u));
        } else if (!met[u] && in(u) && !narrow_facet(labelling, sites, part[i], k, radius)) {
          met[u] = 1, part.push_back(u);
        }
      }
    unique_sorted(around);
    if (around.size() >= 2 && part.size() <= kLargestBar) parts.push_back(std::move(part));
  }
  return smallest_first(std::move(parts));
}

}  // namespace filmsticking
