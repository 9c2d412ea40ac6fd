// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "labelling/labelling.h"
#include "labelling/piece_names.h"

namespace filmsticking {

/// What may bar the mouth of a cavity: the parts of the inside, connected through facets of at least this
/// radius, that lie between several pieces of the outside, smallest first.
std::vector<Move> bars(const Labelling& labelling, PieceNames& pieces, const std::vector<Vec3>& sites,
                       double radius);

}  // namespace filmsticking
