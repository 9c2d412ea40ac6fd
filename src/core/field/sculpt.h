// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "facet_evidence.h"
#include "work_limits.h"
#include "tetrahedral_mesh.h"

namespace filmsticking {

/// Sculpting (paper, section 5; Wang et al. 2022) as a minimum cut: the inside of a shape among the Delaunay
/// tetrahedra that costs least between what is believed of each tetrahedron and what its facets cost as
/// surface. hold[t]: > 0 what it costs to leave t outside, < 0 to have it inside, in the unit of the evidence
/// (area). Infinite ones are outside whatever it says, unless the surface may be `open`: then it may reach
/// infinity, which is where its rim is.
std::vector<char> sculpt(const TetrahedralMesh& mesh, const FacetEvidence& evidence,
                         const std::vector<double>& hold, bool open = false, const Cancel& cancel = {});

}  // namespace filmsticking
