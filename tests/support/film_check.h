// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of complexes and films.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "film/dual_complex.h"
#include "geometry/surface.h"
#include "geometry/triangle_adjacency.h"

namespace filmsticking::test {

// Half-edges are paired, each with one that runs back between the same sites.
inline void expect_closed(const HalfEdgeComplex& c) {
  for (Index h = 0; h < static_cast<Index>(c.twin.size()); ++h) {
    ASSERT_EQ(c.twin[c.twin[h]], h);
    ASSERT_NE(c.twin[h], h);
    ASSERT_EQ(c.site[c.twin[h]], c.site[next_in_face(h)]);
  }
}

// A closed manifold on which no site stands twice.
inline void expect_manifold(const Surface& film) {
  EXPECT_TRUE(check_manifold(film.triangles, static_cast<Index>(film.positions.size())).ok());
  std::vector<Index> sites = film.site;
  std::sort(sites.begin(), sites.end());
  EXPECT_TRUE(std::adjacent_find(sites.begin(), sites.end()) == sites.end())
      << "a site stands on two vertices";
}

}  // namespace filmsticking::test
