// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/ways.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>

#include "labelling/narrow.h"

namespace filmsticking {
namespace {

// A piece with less volume than this for each of its sites, in cubes of their spacing, is a shard: it is
// thinner than a tube of two spacings' radius, which would be torn where samples are random.
constexpr double kShard = 1;
// A longer way joins no shard.
constexpr Index kLongest = 100;
// Ways that are tried between the same two pieces.
constexpr int kWays = 3;

// A tetrahedron on a way: the piece that the way starts from, the tetrahedron before, and how many to here.
struct Step {
  Index from = kNone, before = kNone, length = 0;
};

// Where the ways from pieces a and b meet: in t, or in t and u.
struct Meeting {
  Index a, b, length, t, u;
};

// Grows ways from all pieces at once through `small` tetrahedra. Returns where ways of two pieces meet, one
// of which is a shard, sorted by pieces and then by length.
template <class Small>
std::vector<Meeting> meet_ways(const Labelling& labelling, PieceNames& pieces, char label,
                               const std::vector<char>& shard, const Small& small, std::vector<Step>& step) {
  std::vector<Index> queue;
  for (std::size_t s = 0; s < step.size(); ++s) {
    const Index t = static_cast<Index>(s);
    if (!small(t)) continue;
    for (Index u : labelling.neighbours(t))
      if (labelling.label(u) != label && step[t].from == kNone)
        step[t] = {pieces.of(u), kNone, 1}, queue.push_back(t);
  }
  std::vector<Meeting> met;
  const auto meet = [&](Index t, Index other, Index u, Index length) {
    const Index own = step[t].from;
    if (own != other && length <= kLongest && (shard[own] || shard[other]))
      met.push_back({std::min(own, other), std::max(own, other), length, t, u});
  };
  for (std::size_t i = 0; i < queue.size(); ++i) {  // ends: each is met once
    const Index t = queue[i];
    for (Index u : labelling.neighbours(t)) {
      if (labelling.label(u) != label) {
        meet(t, pieces.of(u), kNone, step[t].length);
      } else if (small(u)) {
        if (step[u].from == kNone)
          step[u] = {step[t].from, t, step[t].length + 1}, queue.push_back(u);
        else if (t < u)
          meet(t, step[u].from, u, step[t].length + step[u].length);
      }
    }
  }
  std::sort(met.begin(), met.end(), [](const Meeting& x, const Meeting& y) {
    return std::tie(x.a, x.b, x.length, x.t, x.u) < std::tie(y.a, y.b, y.length, y.t, y.u);
  });
  return met;
}

}  // namespace

std::vector<char> shards(const Labelling& labelling, PieceNames& pieces, const std::vector<Vec3>& sites,
                         char label) {
  std::vector<double> volume(pieces.names(), 0), cover(pieces.names(), 0);
  std::vector<Index> owner(sites.size(), kNone);
  for (std::size_t s = 0; s < labelling.mesh().size(); ++s) {
    const Index t = static_cast<Index>(s);
    if (labelling.label(t) == label) continue;
    const Index own = pieces.of(t);
    if (labelling.infinite(t)) {
      volume[own] = std::numeric_limits<double>::infinity();
      continue;
    }
    const auto& c = labelling.corners(t);
    const Vec3& o = sites[c[0]];
    volume[own] += (sites[c[1]] - o).cross(sites[c[2]] - o).dot(sites[c[3]] - o) / 6;
    for (int k = 0; k < 4; ++k)
      if (labelling.label(labelling.neighbours(t)[k]) == label)
        for (int j : kFacet[k]) owner[c[j]] = own;
  }
  for (std::size_t v = 0; v < owner.size(); ++v)
    if (const double s = labelling.geometry().spacing[v]; owner[v] != kNone) cover[owner[v]] += s * s * s;
  std::vector<char> shard(pieces.names());
  for (std::size_t i = 0; i < shard.size(); ++i) shard[i] = volume[i] < kShard * cover[i];
  return shard;
}

std::vector<Move> ways(const Labelling& labelling, PieceNames& pieces, const std::vector<Vec3>& sites,
                       double radius, char label) {
  const std::vector<char> shard = shards(labelling, pieces, sites, label);
  if (std::count(shard.begin(), shard.end(), 1) == 0) return {};
  const auto small = [&](Index t) { return labelling.label(t) == label && narrow(labelling, t, radius); };
  std::vector<Step> step(labelling.mesh().size());
  const std::vector<Meeting> met = meet_ways(labelling, pieces, label, shard, small, step);
  std::vector<Move> moves;
  for (std::size_t i = 0; i < met.size(); ++i) {
    const Meeting& way = met[i];
    if (i >= kWays && met[i - kWays].a == way.a && met[i - kWays].b == way.b) continue;
    Move move;
    for (Index t : {way.t, way.u})
      for (; t != kNone; t = step[t].before) move.push_back(t);
    moves.push_back(std::move(move));
  }
  return smallest_first(std::move(moves));
}

}  // namespace filmsticking
