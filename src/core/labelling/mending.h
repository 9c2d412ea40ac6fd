// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "labelling/labelling.h"
#include "labelling/piece_names.h"

namespace filmsticking {

/// What a mend is worth and costs, in sites off the surface, and how it is tried.
struct MendTerms {
  double tunnel = 0;   ///< Worth of a handle less.
  double tear = 0;     ///< Worth of a piece less.
  double size = 0;     ///< Cost of each tetrahedron of the part.
  bool relax = false;  ///< The surroundings may follow, without a change of topology, before the costs count.
  std::size_t look = std::numeric_limits<std::size_t>::max();  ///< PieceNames::parted(): `most`.
};

/// Tries mends on a labelling that is a manifold. A mend relabels a part, all of one label, and repairs what
/// that makes singular. It is kept if it costs less than it is worth, and leaves fewer handles or fewer
/// pieces, and not more of either; else nothing changes. A tunnel that samples line is not filled.
class Mending {
 public:
  explicit Mending(Labelling& of) : labelling(of) {}

  /// Needed before the first try. Where the surface is a manifold now, it must stay one. Returns the number
  /// of pieces of both labels.
  std::int64_t name_pieces();

  /// Tries the parts in their order, apart from those that an earlier one has changed.
  void try_all(const std::vector<Move>& parts, char label, const MendTerms& terms);

  /// Handles of the surface, with its sheets at singular sites taken apart, at the last naming. A surface
  /// that goes through infinity may have fewer.
  std::int64_t handles() const;

  Labelling& labelling;
  PieceNames pieces;

 private:
  void try_one(const Move& part, const MendTerms& terms);
};

}  // namespace filmsticking
