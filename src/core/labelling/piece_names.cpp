// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/piece_names.h"

#include <algorithm>
#include <numeric>

#include "labelling/label_islands.h"

namespace filmsticking {

void PieceNames::name(const Labelling& labelling) {
  count_ = static_cast<std::int64_t>(label_pieces(labelling.mesh(), labelling.labels(), piece_));
  alias_.resize(static_cast<std::size_t>(count_));
  std::iota(alias_.begin(), alias_.end(), 0);
}

Index PieceNames::of(Index t) {
  Index name = piece_[t];
  while (alias_[name] != name) name = alias_[name] = alias_[alias_[name]];
  return name;
}

int PieceNames::count_around(const Labelling& labelling, const Move& part) {
  std::vector<Index> names;
  for (Index t : part) {
    names.push_back(of(t));
    for (Index u : labelling.neighbours(t)) names.push_back(of(u));
  }
  unique_sorted(names);
  return static_cast<int>(names.size());
}

void PieceNames::unite_around(Labelling& labelling, const Move& part) {
  labelling.marks.clear();
  for (Index t : part) labelling.marks.add(t);
  Index name[2] = {kNone, kNone};
  for (Index t : part)
    for (Index u : labelling.neighbours(t)) {
      if (labelling.marks.has(u)) continue;
      Index& own = name[labelling.label(u) ? 1 : 0];
      const Index other = of(u);
      if (own == kNone) own = other;
      alias_[other] = own;
    }
  for (Index t : part) {
    Index& own = name[labelling.label(t) ? 1 : 0];
    if (own == kNone) own = static_cast<Index>(alias_.size()), alias_.push_back(own);
    piece_[t] = own;
  }
}

// All of the label around the part grows at the same pace until it has met, or one piece ends. So it takes no
// longer than the smaller piece.
bool PieceNames::parted(Labelling& labelling, const Move& part, char label, std::size_t most) {
  Marks& seen = labelling.marks;
  seen.clear();
  std::vector<Index> queue, root, waiting;
  const auto start_at = [&](Index t) {
    if (!seen.has(t) && labelling.label(t) == label) seen.add(t), queue.push_back(t);
  };
  for (Index t : part) {
    start_at(t);
    for (Index u : labelling.neighbours(t)) start_at(u);
  }
  source_.resize(labelling.mesh().size());
  for (std::size_t i = 0; i < queue.size(); ++i) {
    root.push_back(static_cast<Index>(i)), waiting.push_back(1);
    source_[queue[i]] = static_cast<Index>(i);
  }
  const auto find = [&](Index i) {  // ends: a forest, whose paths become shorter
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  std::size_t pieces = queue.size();
  for (std::size_t i = 0; i < std::min(most, queue.size()) && pieces > 1; ++i) {
    const Index own = find(source_[queue[i]]);
    for (Index u : labelling.neighbours(queue[i])) {
      if (labelling.label(u) != label) continue;
      if (!seen.has(u)) {
        seen.add(u), source_[u] = own;
        queue.push_back(u);
        ++waiting[own];
      } else if (const Index other = find(source_[u]); other != own) {
        root[other] = own, waiting[own] += waiting[other], --pieces;
      }
    }
    ++labelling.counts.visits;
    if (--waiting[own] == 0) return pieces > 1;
  }
  return false;
}

}  // namespace filmsticking
