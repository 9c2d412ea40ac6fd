// SPDX-License-Identifier: GPL-3.0-or-later
// Widths in spacings, by which parts are found that may mend the surface; and their order.
#pragma once

#include <algorithm>
#include <vector>

#include "geometry/triangle_circle.h"
#include "labelling/labelling.h"

namespace filmsticking {

/// Has a tetrahedron a circumsphere of less than this radius, in the largest spacing of its corners? An
/// infinite one has not.
inline bool narrow(const Labelling& labelling, Index t, double radius) {
  if (labelling.infinite(t)) return false;
  double spacing = 0;
  for (Index v : labelling.corners(t)) spacing = std::max(spacing, labelling.geometry().spacing[v]);
  return labelling.mesh().circumradius[t] < radius * spacing;
}

/// Has facet k of t, of finite corners, a circumcircle of less than this radius, in the largest spacing of
/// these?
inline bool narrow_facet(const Labelling& labelling, const std::vector<Vec3>& sites, Index t, int k,
                         double radius) {
  const auto& c = labelling.corners(t);
  const auto& spacing = labelling.geometry().spacing;
  const Index i = c[kFacet[k][0]], j = c[kFacet[k][1]], l = c[kFacet[k][2]];
  const double widest = radius * std::max({spacing[i], spacing[j], spacing[l]});
  return circumradius2(sites[i], sites[j], sites[l]) < widest * widest;
}

/// In rising order of size, and each sorted.
inline std::vector<Move> smallest_first(std::vector<Move> parts) {
  for (Move& part : parts) std::sort(part.begin(), part.end());
  std::stable_sort(parts.begin(), parts.end(),
                   [](const Move& a, const Move& b) { return a.size() < b.size(); });
  return parts;
}

}  // namespace filmsticking
