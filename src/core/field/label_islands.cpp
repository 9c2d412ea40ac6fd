// SPDX-License-Identifier: GPL-3.0-or-later
#include "label_islands.h"

#include <algorithm>

namespace filmsticking {
namespace {

// The pieces of a labelling, in the order in which they are met from outside in.
struct Pieces {
  std::vector<Index> of;      // [tetrahedron]
  std::vector<Index> parent;  // [piece]: the piece around it; kNone for what holds the infinite tetrahedra

  std::size_t size() const { return parent.size(); }
};

Pieces find_pieces(const TetrahedralMesh& mesh, const std::vector<char>& inside) {
  Pieces pieces;
  pieces.of.assign(mesh.size(), kNone);
  // Seeds: a tetrahedron of a piece not met yet, and the piece it was met from. The list is worked off in
  // order, so a piece comes after the one around it.
  std::vector<std::pair<Index, Index>> seeds;
  std::vector<Index> queue;
  for (std::size_t t = 0; t < mesh.size(); ++t)
    if (mesh.tets.infinite(static_cast<Index>(t))) {
      seeds.emplace_back(static_cast<Index>(t), kNone);
      break;  // the infinite ones are connected
    }
  for (std::size_t next = 0; next < seeds.size(); ++next) {
    const auto [start, from] = seeds[next];
    if (pieces.of[start] != kNone) continue;
    const Index id = static_cast<Index>(pieces.size());
    pieces.parent.push_back(from);
    pieces.of[start] = id;
    queue.assign(1, start);
    while (!queue.empty()) {
      const Index t = queue.back();
      queue.pop_back();
      for (Index u : mesh.tets.neighbours[t]) {
        if (pieces.of[u] != kNone) continue;
        if (inside[u] == inside[t]) {
          pieces.of[u] = id;
          queue.push_back(u);
        } else {
          seeds.emplace_back(u, id);
        }
      }
    }
  }
  return pieces;
}

}  // namespace

std::int64_t drop_islands(const TetrahedralMesh& mesh, const SiteGeometry& geometry,
                          std::vector<char>& inside) {
  const Pieces pieces = find_pieces(mesh, inside);
  if (pieces.size() <= 2) return 0;  // one surface
  // A component of the surface belongs to the piece it is around; a site, to the last such piece.
  std::vector<Index> owner(geometry.near.size(), kNone);
  for (std::size_t t = 0; t < mesh.size(); ++t) {
    const Index piece = pieces.of[t];
    for (int k = 0; k < 4; ++k)
      if (pieces.parent[piece] != kNone && pieces.of[mesh.tets.neighbours[t][k]] == pieces.parent[piece])
        for (int j : kFacet[k])
          if (const Index v = mesh.tets.corners[t][j]; v != kNone) owner[v] = piece;
  }
  std::vector<std::int64_t> own(pieces.size(), 0), foreign(pieces.size(), 0);
  for (std::size_t v = 0; v < owner.size(); ++v) {
    if (owner[v] == kNone) continue;
    for (Index other : geometry.near[v])
      if (other != kNone) ++(owner[other] == owner[v] ? own : foreign)[owner[v]];
  }
  // From outside in: an island takes the label that what is around it has in the end.
  std::int64_t islands = 0;
  std::vector<char> label(pieces.size(), 0);
  for (std::size_t t = 0; t < mesh.size(); ++t) label[pieces.of[t]] = inside[t];
  for (std::size_t p = 0; p < pieces.size(); ++p)
    if (pieces.parent[p] != kNone && own[p] <= foreign[p]) label[p] = label[pieces.parent[p]], ++islands;
  for (std::size_t t = 0; t < mesh.size(); ++t) inside[t] = label[pieces.of[t]];
  return islands;
}

}  // namespace filmsticking
