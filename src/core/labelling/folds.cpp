// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/folds.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace filmsticking {
namespace {

// A pile of so many flat tetrahedra is a flat cloud.
constexpr std::size_t kFlatPile = 16;

// Among some tetrahedra and their neighbours.
int folds_around(const Labelling& labelling, const Move& move) {
  std::vector<Index> met = move;
  for (Index t : move) met.insert(met.end(), labelling.neighbours(t).begin(), labelling.neighbours(t).end());
  unique_sorted(met);
  return static_cast<int>(
      std::count_if(met.begin(), met.end(), [&](Index t) { return folded(labelling, t); }));
}

}  // namespace

bool folded(const Labelling& labelling, Index t) {
  const TetrahedralMesh& mesh = labelling.mesh();
  const int side = mesh.flat[t];
  if (side == 0) return false;
  int met = 0;
  for (int k = 0; k < 4; ++k)
    if (labelling.label(mesh.tets.neighbours[t][k]) != labelling.label(t)) met |= (side >> k & 1) ? 1 : 2;
  if (met != 3) return false;
  if (!labelling.label(t)) return true;
  std::array<Index, kFlatPile> pile{t};
  std::size_t size = 1;
  for (std::size_t i = 0; i < size; ++i)
    for (Index u : mesh.tets.neighbours[pile[i]]) {
      if (!labelling.label(u)) continue;
      if (!mesh.flat[u]) return true;
      if (size < kFlatPile && std::find(pile.begin(), pile.begin() + size, u) == pile.begin() + size)
        pile[size++] = u;
    }
  return false;
}

int more_folds(Labelling& labelling, const Move& move) {
  const int before = folds_around(labelling, move);
  return labelling.as_if(move, [&] { return folds_around(labelling, move); }) - before;
}

}  // namespace filmsticking
