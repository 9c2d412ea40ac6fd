// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "labelling/labelling.h"

namespace filmsticking {

/// Relabels towards `aim` as far as the topology allows: each step gives one tetrahedron the label of the aim
/// and leaves a manifold of the same Euler characteristic, as homotopic deformation does in digital topology
/// (Kong and Rosenfeld, "Digital topology: introduction and survey", 1989). So the labels take the sites that
/// the aim holds, and none of its handles and islands. Needs a census.
void warp(Labelling& labelling, const std::vector<char>& aim);

}  // namespace filmsticking
