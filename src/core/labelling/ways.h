// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "labelling/labelling.h"
#include "labelling/piece_names.h"

namespace filmsticking {

/// [name]: is the piece a shard, thinner than any part that samples resolve? Of the pieces that have not this
/// label.
std::vector<char> shards(const Labelling& labelling, PieceNames& pieces, const std::vector<Vec3>& sites,
                         char label);

/// The shortest ways through tetrahedra of a label, narrower than `radius`, from shards to other pieces,
/// shortest first.
std::vector<Move> ways(const Labelling& labelling, PieceNames& pieces, const std::vector<Vec3>& sites,
                       double radius, char label);

}  // namespace filmsticking
