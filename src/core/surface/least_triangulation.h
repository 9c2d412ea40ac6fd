// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "geometry/vec.h"

namespace filmsticking {

/// The triangulation of a polygon by its corners whose faces cost least together, by dynamic programming over
/// parts of it (Barequet and Sharir 1995, "Filling gaps in the boundary of a polyhedron"). Time grows with
/// the cube of the corners.
///
/// `chord_allowed(i, k)`: may corners i < k, not beside each other, be joined? `cost(i, j, k)`: of a face
/// with corners i < j < k; infinite: never. Empty if there is none. `before_row()`: called before every
/// length; may throw.
template <class ChordAllowed, class Cost, class BeforeRow>
std::vector<Corners> least_triangulation(const std::vector<Index>& line, const ChordAllowed& chord_allowed,
                                         const Cost& cost, const BeforeRow& before_row) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const std::size_t n = line.size();
  std::vector<double> least(n * n, 0);
  std::vector<std::size_t> middle(n * n, 0);
  for (std::size_t i = 0; i + 2 < n; ++i)
    for (std::size_t k = i + 2; k < n; ++k)
      if ((i > 0 || k + 1 < n) && !chord_allowed(i, k)) least[i * n + k] = kNever;
  for (std::size_t length = 2; length < n; ++length) {
    before_row();
    for (std::size_t i = 0; i + length < n; ++i) {
      const std::size_t k = i + length;
      if (!(least[i * n + k] < kNever)) continue;
      double best = kNever;
      for (std::size_t j = i + 1; j < k; ++j) {
        const double parts = least[i * n + j] + least[j * n + k];
        if (!(parts < best)) continue;
        const double with = parts + cost(i, j, k);
        if (with < best) best = with, middle[i * n + k] = j;
      }
      least[i * n + k] = best;
    }
  }
  if (n < 3 || !(least[n - 1] < kNever)) return {};
  std::vector<Corners> faces;
  std::vector<std::array<std::size_t, 2>> open{{0, n - 1}};
  while (!open.empty()) {  // ends: both parts are shorter
    const auto [i, k] = open.back();
    open.pop_back();
    if (k < i + 2) continue;
    const std::size_t j = middle[i * n + k];
    faces.push_back({line[i], line[j], line[k]});
    open.push_back({i, j}), open.push_back({j, k});
  }
  return faces;
}

}  // namespace filmsticking
