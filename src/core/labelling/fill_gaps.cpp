// SPDX-License-Identifier: GPL-3.0-or-later
// ManifoldLabels: tunnels that no samples line, walls and limbs that are torn, and chance bridges.
#include <algorithm>
#include <cstddef>
#include <numeric>

#include "labelling/label_islands.h"
#include "labelling/manifold_labels.h"

namespace filmsticking {
namespace {

// Circumradii, in the largest spacing of the corners, up to which tetrahedra outside are taken for a part of
// a plug, the narrowest first. Two sides of a thin wall have gaps of up to four spacings at the same place.
constexpr double kPlugRadii[] = {1, 1.25, 1.5, 1.75, 2, 2.5, 3, 4};
// The same of a facet of a cap. Wide tetrahedra have narrow facets where one side of a wall has a large gap
// and samples of the other fill half of it.
constexpr double kCapRadii[] = {0.5, 0.75, 1};
// The same of tetrahedra of ways between pieces, of those outside that discs may fill a tunnel with, and of
// those inside that may be a bridge: what is inside of a wall is as narrow.
constexpr double kWayRadii[] = {1, 1.25, 1.5, 1.75, 2, 2.5, 3, 4}, kTunnelRadii[] = {1, 1.5, 2, 3},
                 kBridgeRadii[] = {1, 1.5};
// A larger plug fills no chance gap.
constexpr std::size_t kLargestPlug = 3000;
// How much less filling a tunnel is worth for each tetrahedron of a disc where the surface is smooth: chance
// gaps are small then, those in noise are not.
constexpr double kTunnelSize = 0.05;
// How much more, for each unit of lining less than none, as far as the surface is smooth: a sample that shows
// a gap is two thirds of one. The more there are, the wider is the gap, and the more its disc costs.
constexpr double kGapWorth = 0.6;
// What cutting a bridge is worth and what joining a shard is, and how much more on a rough surface: of noise,
// where evidence is weak. There is no chance bridge between smooth surfaces, and two parts may lie close to
// each other.
constexpr double kBridgeWorth = 1, kBridgeWorthRough = 2, kShardWorth = 0.5, kShardWorthRough = 1.5;
// A surface is rough if its facets face this much away from the mean of those around their corners, as 1 less
// the median cosine: noise of half the spacing.
constexpr double kRough = 0.2;
// What a cap costs is known when its surroundings are at rest. More rounds than a tetrahedron is wide lead
// away from it.
constexpr int kRelaxRounds = 10;
// What is worth a move then, in sites off the surface: more than rounding.
constexpr double kRelaxGain = 1e-6;

}  // namespace

// Has a tetrahedron a circumsphere of less than this radius, in the largest spacing of its corners?
bool ManifoldLabels::narrow(Index t, double radius) const {
  if (mesh_.tets.infinite(t)) return false;
  double spacing = 0;
  for (Index v : mesh_.tets.corners[t]) spacing = std::max(spacing, geometry_.spacing[v]);
  return mesh_.circumradius[t] < radius * spacing;
}

// By size, and each sorted.
std::vector<ManifoldLabels::Move> ManifoldLabels::smallest_first(std::vector<Move> parts) {
  for (Move& part : parts) std::sort(part.begin(), part.end());
  std::stable_sort(parts.begin(), parts.end(),
                   [](const Move& a, const Move& b) { return a.size() < b.size(); });
  return parts;
}

// The narrow tetrahedra outside, by connected parts in rising order of size; but for parts that are narrow
// all over by an earlier radius, which have been met.
std::vector<ManifoldLabels::Move> ManifoldLabels::plugs(double radius, double earlier) const {
  const auto small = [&](Index t) { return !inside_[t] && narrow(t, radius); };
  std::vector<char> met(mesh_.size(), 0);
  std::vector<Move> parts;
  for (std::size_t s = 0; s < mesh_.size(); ++s) {
    if (met[s] || !small(static_cast<Index>(s))) continue;
    met[s] = 1;
    Move part{static_cast<Index>(s)};
    std::size_t beside_outside = 0;
    bool seen = true;
    for (std::size_t i = 0; i < part.size(); ++i) {
      seen = seen && narrow(part[i], earlier);
      for (Index u : mesh_.tets.neighbours[part[i]]) {
        if (met[u]) continue;
        if (small(u)) {
          met[u] = 1, part.push_back(u);
        } else {
          beside_outside += !inside_[u];
        }
      }
    }
    // A plug has two caps.
    if (!seen && beside_outside >= 2 && part.size() <= kLargestPlug) parts.push_back(std::move(part));
  }
  return smallest_first(std::move(parts));
}

// Is one label in several pieces around tetrahedra that were relabelled? All of it that is there is grown at
// the same pace until it has met, or one piece ends: it takes no longer than the smaller piece. Pieces that
// have not ended after `most` tetrahedra count as one.
bool ManifoldLabels::parted(const Move& part, char label, std::size_t most) {
  ++stamp_;
  std::vector<Index> queue, root, waiting;
  const auto start_at = [&](Index t) {
    if (seen_[t] != stamp_ && inside_[t] == label) seen_[t] = stamp_, queue.push_back(t);
  };
  for (Index t : part) {
    start_at(t);
    for (Index u : mesh_.tets.neighbours[t]) start_at(u);
  }
  source_.resize(mesh_.size());
  for (std::size_t i = 0; i < queue.size(); ++i) {
    root.push_back(static_cast<Index>(i)), waiting.push_back(1);
    source_[queue[i]] = static_cast<Index>(i);
  }
  const auto find = [&](Index i) {  // ends: a forest, whose ways are made shorter
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  std::size_t pieces = queue.size();
  for (std::size_t i = 0; i < std::min(most, queue.size()) && pieces > 1; ++i) {
    const Index own = find(source_[queue[i]]);
    for (Index u : mesh_.tets.neighbours[queue[i]]) {
      if (inside_[u] != label) continue;
      if (seen_[u] != stamp_) {
        seen_[u] = stamp_, source_[u] = own;
        queue.push_back(u);
        ++waiting[own];
      } else if (const Index other = find(source_[u]); other != own) {
        root[other] = own, waiting[own] += waiting[other], --pieces;
      }
    }
    ++counts_.visits;
    if (--waiting[own] == 0) return pieces > 1;
  }
  return false;
}

Index ManifoldLabels::piece(Index t) {
  Index name = piece_[t];
  while (alias_[name] != name) name = alias_[name] = alias_[alias_[name]];
  return name;
}

// How many pieces there are among the tetrahedra of a part and beside it.
int ManifoldLabels::pieces_around(const Move& part) {
  std::vector<Index> names;
  for (Index t : part) {
    names.push_back(piece(t));
    for (Index u : mesh_.tets.neighbours[t]) names.push_back(piece(u));
  }
  unique_sorted(names);
  return static_cast<int>(names.size());
}

// After a part was relabelled, around which each label is one piece now.
void ManifoldLabels::unite_around(const Move& part) {
  ++stamp_;
  for (Index t : part) seen_[t] = stamp_;
  Index name[2] = {kNone, kNone};
  for (Index t : part)
    for (Index u : mesh_.tets.neighbours[t]) {
      if (seen_[u] == stamp_) continue;
      Index& own = name[inside_[u] ? 1 : 0];
      const Index other = piece(u);
      if (own == kNone) own = other;
      alias_[other] = own;
    }
  for (Index t : part) {
    Index& own = name[inside_[t] ? 1 : 0];
    if (own == kNone) own = static_cast<Index>(alias_.size()), alias_.push_back(own);
    piece_[t] = own;
  }
}

// Fills a plug, or takes a bar away, and repairs what that makes singular, if what it mends is worth it all;
// else changes nothing.
void ManifoldLabels::fill(const Move& plug, const Terms& terms) {
  const auto worth = [&](int handles, int pieces) {
    return (terms.tunnel * handles + terms.tear * pieces) * site_cost_;
  };
  const Effect alone = effect(plug);
  if (!terms.relax && alone.surplus == 0 && pieces_around(plug) <= 2 &&
      (alone.euler <= 0 || alone.cost >= worth(alone.euler / 2, 0)))
    return;
  double cost = terms.size * static_cast<double>(plug.size()) * site_cost_;
  int euler = 0;
  std::vector<Index> singular, next, changed;
  const auto make = [&](const Move& move, std::vector<Index>& then) {
    const Effect e = effect(move);
    cost += e.cost, euler += e.euler;
    apply(move, then);
    changed.insert(changed.end(), move.begin(), move.end());
  };
  make(plug, singular);
  bool manifold = true;
  // Every move lowers the number of surplus pieces, so this ends; a plug that needs as many as it is large is
  // none.
  while (!singular.empty() && manifold) {
    unique_sorted(singular);
    next.clear();
    for (Index v : singular) {
      if (!this->singular(v)) continue;
      const Move move = best_move(v, false);
      manifold = !move.empty() && changed.size() <= 4 * plug.size() + 16;
      if (!manifold) break;
      make(move, next);
    }
    singular.swap(next);
  }
  const auto come_to_rest = [&] {
    std::vector<Index> front = changed;
    for (int round = 0; round < kRelaxRounds && !front.empty(); ++round) {
      next = front;
      for (Index t : front)
        next.insert(next.end(), mesh_.tets.neighbours[t].begin(), mesh_.tets.neighbours[t].end());
      unique_sorted(next);
      front.clear();
      for (Index t : next) {
        const Move move{t};
        if (!allowed(move) || !grows(move)) continue;
        const Effect e = effect(move);
        if (e.surplus != 0 || e.euler != 0 || e.cost > -kRelaxGain * site_cost_) continue;
        make(move, singular);
        front.push_back(t);
      }
    }
  };
  if (manifold && !parted(changed, 0, terms.look) && !parted(changed, 1, terms.look)) {
    bool present[2] = {false, false};
    for (Index t : changed) {
      present[inside_[t] ? 1 : 0] = true;
      for (Index u : mesh_.tets.neighbours[t]) present[inside_[u] ? 1 : 0] = true;
    }
    // Components of the surface are pieces of both labels less one; handles, components less half of the
    // Euler characteristic.
    const int pieces = pieces_around(changed) - present[0] - present[1], handles = euler / 2 + pieces;
    const bool mends = handles >= 0 && pieces >= 0 && handles + pieces > 0;
    if (mends && terms.relax && cost >= worth(handles, pieces)) come_to_rest();
    if (mends && cost < worth(handles, pieces)) {
      unite_around(changed);
      counts_.tunnels += handles > 0;
      counts_.tears += pieces > 0;
      return;
    }
  }
  for (Index t : changed) inside_[t] = !inside_[t];
  unique_sorted(changed);
  for (Index v : sites_of(changed)) census_[v] = census(v);
}

// From the first on, those that another's repair has left as they were.
void ManifoldLabels::fill_all(const std::vector<Move>& plugs, char label, const Terms& terms) {
  for (const Move& plug : plugs) {
    cancel_();
    if (spent()) return;
    const bool whole = std::all_of(plug.begin(), plug.end(), [&](Index t) { return inside_[t] == label; });
    if (whole && grows(plug)) fill(plug, terms);
  }
}

// Returns how many there are. Where the surface is a manifold now it stays one.
std::int64_t ManifoldLabels::name_pieces() {
  for (std::size_t v = 0; v < exempt_.size(); ++v)
    if (census_[v].surplus() == 0) exempt_[v] = 0;
  pieces_ = static_cast<std::int64_t>(label_pieces(mesh_, inside_, piece_));
  alias_.resize(static_cast<std::size_t>(pieces_));
  std::iota(alias_.begin(), alias_.end(), 0);
  return pieces_;
}

// Of the surface, with its sheets at singular places taken apart. One that goes through infinity may have
// fewer.
std::int64_t ManifoldLabels::handles() const {
  std::int64_t euler2 = 0;  // twice the Euler characteristic: V - F / 2, with three edges for two facets
  for (const Census& c : census_)
    if (!c.off()) euler2 += 2 * std::int64_t{c.sheets()};
  for (std::size_t t = 0; t < mesh_.size(); ++t)
    if (inside_[t])
      for (Index u : mesh_.tets.neighbours[t]) euler2 -= !inside_[u];
  return pieces_ - 1 - euler2 / 4;
}

// How rough the surface is: 0 for a smooth one, 1 for one of noise.
double ManifoldLabels::roughness(const std::vector<Vec3>& sites) const {
  const std::vector<Corners> facets = tetrahedral_boundary(mesh_, inside_);
  std::vector<Vec3> normal(facets.size()), mean(sites.size(), Vec3::Zero());
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const Vec3& o = sites[facets[i][0]];
    normal[i] = (sites[facets[i][1]] - o).cross(sites[facets[i][2]] - o);
    for (Index v : facets[i]) mean[v] += normal[i];
  }
  std::vector<double> cosines;
  for (std::size_t i = 0; i < facets.size(); ++i)
    for (Index v : facets[i])
      if (const double size = normal[i].norm() * mean[v].norm(); size > 0)
        cosines.push_back(normal[i].dot(mean[v]) / size);
  if (cosines.empty()) return 0;
  const auto middle = cosines.begin() + static_cast<std::ptrdiff_t>(cosines.size() / 2);
  std::nth_element(cosines.begin(), middle, cosines.end());
  return std::clamp((1 - *middle) / kRough, 0.0, 1.0);
}

void ManifoldLabels::fill_plugs() {
  name_pieces();
  double earlier = 0;
  for (const double radius : kPlugRadii) {
    if (spent()) return;
    fill_all(plugs(radius, earlier), 0, {kTunnelWorth, kTearWorth});
    earlier = radius;
  }
}

void ManifoldLabels::fill_gaps(const std::vector<Vec3>& sites) {
  fill_plugs();
  for (const double radius : kCapRadii)
    if (!spent()) fill_all(caps(sites, radius), 0, {kTunnelWorth, kTearWorth, 0, true});
  name_pieces();
  if (pieces_ <= 2 && handles() == 0) return;
  const double rough = roughness(sites);
  const Terms tunnel{kTunnelWorth, 0, (1 - rough) * kTunnelSize, true},
      bridge{kBridgeWorth + rough * kBridgeWorthRough, 0, 0, true},
      shard{0, kShardWorth + rough * kShardWorthRough, 0, true};
  const auto join = [&](double radius, char label) {
    if (pieces_ <= 2 || spent()) return;
    fill_all(ways(sites, radius, label), label, shard);
    name_pieces();
  };
  const auto close = [&](double radius, char label) {
    if (handles() == 0 || spent()) return;
    for (const Disc& disc : discs(sites, radius, label)) {
      Terms terms = label ? bridge : tunnel;
      if (!label) terms.tunnel += (1 - rough) * kGapWorth * std::max(0.0, -disc.lining);
      fill_all({disc.part}, label, terms);
    }
    name_pieces();
  };
  for (const char label : {char{0}, char{1}})
    for (const double radius : kWayRadii) join(radius, label);
  for (const double radius : kTunnelRadii) close(radius, 0);
  for (const double radius : kBridgeRadii) close(radius, 1);
}

}  // namespace filmsticking
