// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "delaunay/tetrahedral_mesh.h"
#include "evidence/facet_evidence.h"
#include "geometry/work_limits.h"
#include "labelling/minimum_cut.h"

namespace filmsticking {

/// Sculpting (paper, section 5; Wang et al. 2022) as a minimum cut: the labels of the Delaunay tetrahedra
/// that cost least, between what is believed of each tetrahedron and what facets cost on the surface.
/// Infinite tetrahedra are outside, unless the surface may be `open`: then it may reach infinity, which is
/// where its rim is.
///
/// Beliefs may be held more firmly from cut to cut. A cut continues from the flow of the last one, with the
/// same labels as a cut from the start.
class Sculptor {
 public:
  /// hold[t], in the unit of the evidence (area): > 0: the cost of t outside; < 0: its negative, of t inside.
  /// `mesh` must outlive it.
  Sculptor(const TetrahedralMesh& mesh, const FacetEvidence& evidence, const std::vector<double>& hold,
           bool open = false);

  /// [tetrahedron]: 1 inside, 0 outside. Throws Cancelled.
  std::vector<char> cut(const Cancel& cancel = {});

  /// hold[t] was `before` and is `now`, which has the same sign and is no smaller.
  void hold_firmly(Index t, double before, double now);

 private:
  std::int64_t price(double cost) const;

  const TetrahedralMesh& mesh_;
  const bool open_;
  double unit_ = 1;
  CutGraph graph_;
  std::vector<char> fallback_;
};

}  // namespace filmsticking
