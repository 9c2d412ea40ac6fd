// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/labelling.h"

#include <algorithm>
#include <array>
#include <utility>

#include "geometry/parallel.h"
#include "labelling/surface_sheets.h"

namespace filmsticking {
namespace {

// Visits of tetrahedra that a labelling may take, for each site. Surfaces take a few hundred, two sides that
// confuse the layers of thin walls up to 2,400. Where all sites are neighbours, as on a moment curve, a star
// has as many tetrahedra as there are sites; without a bound the repair would take the fourth power.
constexpr std::int64_t kMostVisits = 10000;

// A star of no more tetrahedra is searched as a list.
constexpr std::size_t kQuickStar = 96;

}  // namespace

Labelling::Labelling(const TetrahedralMesh& mesh, const SiteGeometry& geometry, const LabelCosts& costs,
                     std::vector<char>& labels, const Cancel& cancel)
    : marks(mesh.size()),
      mesh_(mesh),
      geometry_(geometry),
      costs_(costs),
      cancel_(cancel),
      labels_(labels),
      seed_(geometry.near.size(), kNone),
      census_(geometry.near.size()),
      exempt_(geometry.near.size(), 0) {
  for (std::size_t t = 0; t < mesh.size(); ++t)
    for (Index v : mesh.tets.corners[t])
      if (v != kNone) seed_[v] = static_cast<Index>(t);
  for (double c : costs.off) site_cost_ += c / static_cast<double>(costs.off.size());
}

// One thread counts the visits, so this is true from the same move on for any number of threads.
bool Labelling::spent() const {
  return counts.visits > kMostVisits * static_cast<std::int64_t>(seed_.size());
}

Census Labelling::search_star(Index v) {
  marks.clear();
  Census result;
  star_.clear(), first_.clear();
  waiting_.assign(1, seed_[v]);
  // Ends: a tetrahedron is searched from once, and waits no more often than it has neighbours.
  while (!waiting_.empty()) {
    const Index start = waiting_.back();
    waiting_.pop_back();
    if (marks.has(start)) continue;
    const char own_label = labels_[start];
    ++(own_label ? result.inside : result.outside);
    first_.push_back(star_.size());
    marks.add(start);
    star_.push_back(start);
    for (std::size_t next = star_.size() - 1; next < star_.size(); ++next) {
      const Index t = star_[next];
      const int own = corner(t, v);
      for (int k = 0; k < 4; ++k) {
        if (k == own) continue;
        const Index u = neighbours(t)[k];
        if (marks.has(u)) continue;
        if (labels_[u] == own_label) {
          marks.add(u);
          star_.push_back(u);
        } else {
          waiting_.push_back(u);
        }
      }
    }
  }
  first_.push_back(star_.size());
  counts.visits += static_cast<std::int64_t>(star_.size());
  return result;
}

bool Labelling::mixed(Index t, int a, int b) {
  int met = 0;
  around_edge(t, a, b, [&](Index u) { return (met |= labels_[u] ? 1 : 2) != 3; });
  return met == 3;
}

// The census of v now that t, a tetrahedron of its star, has changed labels, where it was plain before. On a
// small sphere around v both parts were discs. So what t did to them shows where their common border, a
// simple curve, meets t's triangle, and no star need be searched.
Census Labelling::census_of_flip(Index v, Index t, const Census& before) {
  const bool now = labels_[t], was = !now;
  const int own = corner(t, v);
  int border = 0, apart = own;
  for (int k = 0; k < 4; ++k)
    if (k != own && (labels_[neighbours(t)[k]] != 0) != was) ++border, apart = k;
  int rest = 1, gain = 1;  // pieces of the label it had, and of the other
  if (border == 3) {
    rest = 0;
  } else if (border == 1) {
    rest = mixed(t, own, apart) ? 2 : 1;  // if the curve meets the triangle's far corner as well, t cuts
  } else if (border == 0) {
    int met = 0;
    for (int k = 0; k < 4; ++k) met += k != own && mixed(t, own, k);
    rest = std::max(1, met);
    gain = (now ? before.inside : before.outside) + 1;
  }
  return now ? Census{gain, rest} : Census{rest, gain};
}

// The census of v now that a move has been made; census_ holds the one before it.
Census Labelling::census_after(Index v, const Move& move) {
  if (!census_[v].plain() || move.size() > 2) return search_star(v);
  const auto has = [&](Index t) { return corners(t)[corner(t, v)] == v; };
  if (move.size() == 1 || !has(move[1])) return census_of_flip(v, move[0], census_[v]);
  if (!has(move[0])) return census_of_flip(v, move[1], census_[v]);
  for (const auto& [first, second] : {std::pair(move[0], move[1]), std::pair(move[1], move[0])}) {
    flip(second);  // one after the other
    const Census between = census_of_flip(v, first, census_[v]);
    flip(second);
    if (between.plain()) return census_of_flip(v, second, between);
  }
  return search_star(v);
}

// As search_star(), without its results and counts, so that several threads may call it. False: the star is
// too large to be searched as a list.
bool Labelling::quick_census(Index v, Census& result) const {
  std::array<Index, kQuickStar> star, waiting;
  std::size_t size = 0, waits = 1;
  waiting[0] = seed_[v];
  result = {};
  const auto met = [&](Index t) {
    const auto end = star.begin() + static_cast<std::ptrdiff_t>(size);
    return std::find(star.begin(), end, t) != end;
  };
  while (waits > 0) {  // ends as search_star() does
    const Index start = waiting[--waits];
    if (met(start)) continue;
    if (size == kQuickStar) return false;
    const char own_label = labels_[start];
    ++(own_label ? result.inside : result.outside);
    std::size_t next = size;
    star[size++] = start;
    for (; next < size; ++next) {
      const Index t = star[next];
      const int own = corner(t, v);
      for (int k = 0; k < 4; ++k) {
        const Index u = neighbours(t)[k];
        if (k == own || met(u)) continue;
        if (size == kQuickStar || waits == kQuickStar) return false;
        (labels_[u] == own_label ? star[size++] : waiting[waits++]) = u;
      }
    }
  }
  return true;
}

std::vector<Index> Labelling::take_census() {
  const std::vector<Sheets> sheets = surface_sheets(mesh_, labels_, seed_.size());
  std::vector<char> large(seed_.size(), 0);
  parallel_each(seed_.size(), [&](std::size_t v) {
    if (seed_[v] == kNone) return;
    if (sheets[v] == Sheets::None)
      census_[v] = labels_[seed_[v]] ? Census{1, 0} : Census{0, 1};
    else if (sheets[v] == Sheets::Disc)
      census_[v] = {1, 1};
    else
      large[v] = !quick_census(static_cast<Index>(v), census_[v]);
  });
  std::vector<Index> found;
  for (std::size_t v = 0; v < seed_.size(); ++v) {
    if (seed_[v] == kNone) continue;
    if (large[v]) census_[v] = search_star(static_cast<Index>(v));
    if (singular(static_cast<Index>(v))) found.push_back(static_cast<Index>(v));
  }
  return found;
}

const std::vector<Index>& Labelling::recount(const Move& changed) {
  for (Index v : sites_of(changed)) census_[v] = search_star(v);
  return touched_;
}

void Labelling::exempt(std::vector<char> sites) {
  if (!sites.empty()) exempt_ = std::move(sites);
}

void Labelling::exempt_no_more() {
  for (std::size_t v = 0; v < exempt_.size(); ++v)
    if (census_[v].surplus() == 0) exempt_[v] = 0;
}

bool Labelling::allowed(const Move& move) const {
  return !move.empty() && std::none_of(move.begin(), move.end(), [&](Index t) { return infinite(t); });
}

bool Labelling::grows(const Move& move) const {
  for (Index t : move)
    for (Index u : neighbours(t))
      if (labels_[u] != labels_[t]) return true;
  return false;
}

double Labelling::flip_cost(Index t) const {
  double cost = labels_[t] ? costs_.hold[t] : -costs_.hold[t];
  for (int k = 0; k < 4; ++k)
    cost += labels_[neighbours(t)[k]] == labels_[t] ? costs_.facet[t][k] : -costs_.facet[t][k];
  return cost;
}

double Labelling::least_cost(const Move& move, double piece) {
  double cost = 0;
  for (Index t : move) {
    cost += flip_cost(t);
    flip(t);
  }
  for (Index t : move) flip(t);
  for (Index v : sites_of(move))
    cost -= piece * census_[v].surplus() + (census_[v].off() ? costs_.off[v] : 0);
  return cost;
}

Effect Labelling::effect(const Move& move) {
  cancel_();
  Effect e;
  int facets = 0;
  touched_.clear();
  for (Index t : move) {
    e.cost += flip_cost(t);
    for (Index u : neighbours(t)) facets += labels_[u] == labels_[t] ? 1 : -1;
    flip(t);
    for (Index v : corners(t))
      if (std::find(touched_.begin(), touched_.end(), v) == touched_.end()) touched_.push_back(v);
  }
  // With all sheets apart the surface has three edges for two facets: V - E + F = V - F / 2.
  e.euler = -facets / 2;
  for (Index v : touched_) {
    const Census now = census_after(v, move);
    e.surplus += now.surplus() - census_[v].surplus();
    e.euler += now.sheets() - census_[v].sheets();
    const int leaves = static_cast<int>(now.off()) - static_cast<int>(census_[v].off());
    e.off += leaves;
    e.cost += leaves * costs_.off[v];
  }
  for (Index t : move) flip(t);
  return e;
}

const std::vector<Index>& Labelling::sites_of(const Move& move) {
  touched_.clear();
  for (Index t : move) touched_.insert(touched_.end(), corners(t).begin(), corners(t).end());
  unique_sorted(touched_);
  // Of an outer tetrahedron: the inside of an open surface may reach infinity.
  if (!touched_.empty() && touched_.front() == kNone) touched_.erase(touched_.begin());
  return touched_;
}

Labelling::Made Labelling::make(const Move& move, std::vector<Index>* singular_sites) {
  cancel_();
  Made made;
  Effect& e = made.effect;
  int facets = 0;
  for (Index t : move) {
    e.cost += flip_cost(t);
    for (Index u : neighbours(t)) facets += labels_[u] == labels_[t] ? 1 : -1;
    flip(t);
  }
  e.euler = -facets / 2;
  for (Index v : sites_of(move)) {
    const Census before = census_[v], now = census_after(v, move);
    made.before.push_back(before);
    census_[v] = now;
    e.surplus += now.surplus() - before.surplus();
    e.euler += now.sheets() - before.sheets();
    const int leaves = static_cast<int>(now.off()) - static_cast<int>(before.off());
    e.off += leaves;
    e.cost += leaves * costs_.off[v];
    if (singular_sites != nullptr && singular(v)) singular_sites->push_back(v);
  }
  return made;
}

std::vector<Census> Labelling::apply(const Move& move, std::vector<Index>* singular_sites) {
  return make(move, singular_sites).before;
}

void Labelling::unmake(const Move& move, const std::vector<Census>& before) {
  for (Index t : move) flip(t);
  const std::vector<Index>& at = sites_of(move);
  for (std::size_t i = 0; i < at.size(); ++i) census_[at[i]] = before[i];
}

Labelling::Snapshot Labelling::snapshot() const { return {labels_, exempt_, census_, counts}; }

void Labelling::restore(Snapshot snapshot) {
  labels_ = std::move(snapshot.labels);
  exempt_ = std::move(snapshot.exempt);
  census_ = std::move(snapshot.census);
  snapshot.counts.visits = counts.visits;
  counts = snapshot.counts;
}

}  // namespace filmsticking
