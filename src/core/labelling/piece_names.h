// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "labelling/labelling.h"

namespace filmsticking {

/// Names of the pieces of both labels, connected through facets, kept while mends join them.
class PieceNames {
 public:
  /// Names all pieces anew.
  void name(const Labelling& labelling);

  std::int64_t count() const { return count_; }        ///< Of pieces, at the last naming.
  std::size_t names() const { return alias_.size(); }  ///< All names are below this.
  Index of(Index t);                                   ///< The name of t's piece.

  /// How many pieces there are among the tetrahedra of a part and beside it.
  int count_around(const Labelling& labelling, const Move& part);

  /// After a part was relabelled, around which each label is one piece now.
  void unite_around(Labelling& labelling, const Move& part);

  /// Is one label in several pieces around tetrahedra that were relabelled? Searches no more than `most`
  /// tetrahedra, and takes pieces that have not ended then for one.
  bool parted(Labelling& labelling, const Move& part, char label, std::size_t most);

 private:
  std::vector<Index> piece_, alias_;  // [tetrahedron]: a name; [name]: another of the same piece, or itself
  std::int64_t count_ = 0;
  std::vector<Index> source_;  // scratch of parted()
};

}  // namespace filmsticking
