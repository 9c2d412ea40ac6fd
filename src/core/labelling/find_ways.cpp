// SPDX-License-Identifier: GPL-3.0-or-later
// ManifoldLabels: ways between pieces that belong together.
#include <algorithm>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>

#include "labelling/manifold_labels.h"

namespace filmsticking {
namespace {

// A piece with less volume than this for each of its sites, in cubes of their spacing, is a shard: it is
// thinner than a tube of two spacings' radius, which would be torn where samples are random.
constexpr double kShard = 1;
// A longer way joins no shard.
constexpr Index kLongest = 100;
// Ways that are tried between the same two pieces.
constexpr int kWays = 3;

}  // namespace

// Of the pieces that have not this label, by name.
std::vector<char> ManifoldLabels::shards(const std::vector<Vec3>& sites, char label) {
  std::vector<double> volume(alias_.size(), 0), cover(alias_.size(), 0);
  std::vector<Index> owner(sites.size(), kNone);
  for (std::size_t s = 0; s < mesh_.size(); ++s) {
    const Index t = static_cast<Index>(s);
    if (inside_[t] == label) continue;
    const Index own = piece(t);
    if (mesh_.tets.infinite(t)) {
      volume[own] = std::numeric_limits<double>::infinity();
      continue;
    }
    const auto& c = mesh_.tets.corners[t];
    const Vec3& o = sites[c[0]];
    volume[own] += (sites[c[1]] - o).cross(sites[c[2]] - o).dot(sites[c[3]] - o) / 6;
    for (int k = 0; k < 4; ++k)
      if (inside_[mesh_.tets.neighbours[t][k]] == label)
        for (int j : kFacet[k]) owner[c[j]] = own;
  }
  for (std::size_t v = 0; v < owner.size(); ++v)
    if (const double s = geometry_.spacing[v]; owner[v] != kNone) cover[owner[v]] += s * s * s;
  std::vector<char> shard(alias_.size());
  for (std::size_t i = 0; i < shard.size(); ++i) shard[i] = volume[i] < kShard * cover[i];
  return shard;
}

// The shortest ways of narrow tetrahedra of a label from shards to other pieces, the shortest first. They
// grow from all pieces at once, and are where two have met.
std::vector<ManifoldLabels::Move> ManifoldLabels::ways(const std::vector<Vec3>& sites, double radius,
                                                       char label) {
  const std::vector<char> shard = shards(sites, label);
  if (std::count(shard.begin(), shard.end(), 1) == 0) return {};
  const auto small = [&](Index t) { return inside_[t] == label && narrow(t, radius); };
  struct Step {
    Index from = kNone, before = kNone,
          length = 0;  // the piece, the tetrahedron before, and how many to here
  };
  std::vector<Step> step(mesh_.size());
  std::vector<Index> queue;
  for (std::size_t s = 0; s < mesh_.size(); ++s) {
    const Index t = static_cast<Index>(s);
    if (!small(t)) continue;
    for (Index u : mesh_.tets.neighbours[t])
      if (inside_[u] != label && step[t].from == kNone) step[t] = {piece(u), kNone, 1}, queue.push_back(t);
  }
  struct Way {
    Index a, b, length, t, u;
  };
  std::vector<Way> met;
  const auto meet = [&](Index t, Index other, Index u, Index length) {
    const Index own = step[t].from;
    if (own != other && length <= kLongest && (shard[own] || shard[other]))
      met.push_back({std::min(own, other), std::max(own, other), length, t, u});
  };
  for (std::size_t i = 0; i < queue.size(); ++i) {  // ends: each is met once
    const Index t = queue[i];
    for (Index u : mesh_.tets.neighbours[t]) {
      if (inside_[u] != label) {
        meet(t, piece(u), kNone, step[t].length);
      } else if (small(u)) {
        if (step[u].from == kNone)
          step[u] = {step[t].from, t, step[t].length + 1}, queue.push_back(u);
        else if (t < u)
          meet(t, step[u].from, u, step[t].length + step[u].length);
      }
    }
  }
  std::sort(met.begin(), met.end(), [](const Way& x, const Way& y) {
    return std::tie(x.a, x.b, x.length, x.t, x.u) < std::tie(y.a, y.b, y.length, y.t, y.u);
  });
  std::vector<Move> moves;
  for (std::size_t i = 0; i < met.size(); ++i) {
    const Way& way = met[i];
    if (i >= kWays && met[i - kWays].a == way.a && met[i - kWays].b == way.b) continue;
    Move move;
    for (Index t : {way.t, way.u})
      for (; t != kNone; t = step[t].before) move.push_back(t);
    moves.push_back(std::move(move));
  }
  return smallest_first(std::move(moves));
}

}  // namespace filmsticking
