// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/label_islands.h"

#include <algorithm>
#include <array>
#include <utility>

#include "geometry/disjoint_sets.h"
#include "geometry/parallel.h"

namespace filmsticking {
namespace {

struct Facet {
  Index t;
  int k;
};

// The pieces of a labelling.
struct Pieces {
  std::vector<Index> of;        // [tetrahedron]
  std::vector<Index> parent;    // [piece]: the piece around it; kNone for the outermost one
  std::vector<Index> outwards;  // the pieces, each after the one around it
  std::vector<Facet> border;    // between pieces, from both sides

  std::size_t size() const { return parent.size(); }
};

constexpr std::size_t kChunk = 16384;

// The facets between pieces, from both sides.
std::vector<Facet> find_border(const TetrahedralMesh& mesh, const std::vector<char>& inside) {
  std::vector<std::vector<Facet>> parts((mesh.size() + kChunk - 1) / kChunk);
  parallel_chunks(mesh.size(), kChunk, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
      for (int k = 0; k < 4; ++k)
        if (inside[mesh.tets.neighbours[t][k]] != inside[t])
          parts[chunk].push_back({static_cast<Index>(t), k});
  });
  std::vector<Facet> border;
  for (const auto& part : parts) border.insert(border.end(), part.begin(), part.end());
  return border;
}

// Of one or two pieces, only their number.
Pieces find_pieces(const TetrahedralMesh& mesh, const std::vector<char>& inside) {
  Pieces pieces;
  pieces.parent.assign(static_cast<std::size_t>(label_pieces(mesh, inside, pieces.of)), kNone);
  if (pieces.size() <= 2) return pieces;
  pieces.border = find_border(mesh, inside);
  std::vector<std::pair<Index, Index>> beside;
  for (const Facet& f : pieces.border) {
    const std::pair<Index, Index> pair =
        std::minmax(pieces.of[f.t], pieces.of[mesh.tets.neighbours[f.t][f.k]]);
    if (beside.empty() || beside.back() != pair) beside.push_back(pair);
  }
  std::sort(beside.begin(), beside.end());
  beside.erase(std::unique(beside.begin(), beside.end()), beside.end());
  for (std::size_t i = 0, pairs = beside.size(); i < pairs; ++i)
    beside.emplace_back(beside[i].second, beside[i].first);
  std::sort(beside.begin(), beside.end());
  // From the piece that holds the infinite tetrahedra, or most of them where the surface is open.
  std::vector<Index> infinite(pieces.size(), 0);
  for (std::size_t t = 0; t < mesh.size(); ++t)
    if (mesh.tets.infinite(static_cast<Index>(t))) ++infinite[pieces.of[t]];
  const auto outermost =
      static_cast<Index>(std::max_element(infinite.begin(), infinite.end()) - infinite.begin());
  pieces.outwards.assign(1, outermost);
  std::vector<char> met(pieces.size(), 0);
  met[outermost] = 1;
  for (std::size_t next = 0; next < pieces.outwards.size(); ++next) {
    const Index p = pieces.outwards[next];
    for (auto it = std::lower_bound(beside.begin(), beside.end(), std::pair(p, Index{0}));
         it != beside.end() && it->first == p; ++it) {
      if (met[it->second]) continue;
      met[it->second] = 1;
      pieces.parent[it->second] = p;
      pieces.outwards.push_back(it->second);
    }
  }
  return pieces;
}

}  // namespace

Index label_pieces(const TetrahedralMesh& mesh, const std::vector<char>& inside, std::vector<Index>& piece) {
  DisjointSets sets(mesh.size());
  parallel_each(mesh.size(), [&](std::size_t t) {
    for (Index u : mesh.tets.neighbours[t])
      if (u < static_cast<Index>(t) && inside[u] == inside[t]) sets.unite(static_cast<Index>(t), u);
  });
  return sets.number(piece);
}

std::int64_t drop_islands(const TetrahedralMesh& mesh, const SiteGeometry& geometry,
                          std::vector<char>& inside) {
  const Pieces pieces = find_pieces(mesh, inside);
  if (pieces.size() <= 2) return 0;  // one surface
  // A component of the surface belongs to the piece that it encloses; a site, to the last such piece.
  std::vector<Index> owner(geometry.near.size(), kNone);
  for (const Facet& f : pieces.border) {
    const Index piece = pieces.of[f.t];
    if (pieces.of[mesh.tets.neighbours[f.t][f.k]] != pieces.parent[piece]) continue;
    for (int j : kFacet[f.k])
      if (const Index v = mesh.tets.corners[f.t][j]; v != kNone) owner[v] = piece;
  }
  std::vector<std::int64_t> own(pieces.size(), 0), foreign(pieces.size(), 0);
  for (std::size_t v = 0; v < owner.size(); ++v) {
    if (owner[v] == kNone) continue;
    for (Index other : geometry.near[v])
      if (other != kNone) ++(owner[other] == owner[v] ? own : foreign)[owner[v]];
  }
  // From outside in: an island takes the final label of the piece around it.
  std::int64_t islands = 0;
  std::vector<char> label(pieces.size(), 0);
  for (const Facet& f : pieces.border) label[pieces.of[f.t]] = inside[f.t];
  for (const Index p : pieces.outwards)
    if (pieces.parent[p] != kNone && own[p] <= foreign[p]) label[p] = label[pieces.parent[p]], ++islands;
  parallel_each(mesh.size(), [&](std::size_t t) { inside[t] = label[pieces.of[t]]; });
  return islands;
}

}  // namespace filmsticking
