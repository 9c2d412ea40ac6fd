// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/manifold_labels.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "geometry/parallel.h"
#include "labelling/label_islands.h"
#include "labelling/surface_sheets.h"

namespace filmsticking {
namespace {

// What a handle more costs in the repair, in sites off the surface: a wall that is pierced by a site of its
// other side is covered there, not opened.
constexpr double kHandlePrice = 20;
// The first share of a site's worth at which it is reached for; it doubles when no site is left at that
// price. The cheap ones first, as they often make the others cheap.
constexpr double kFirstShare = 0.1;

// A site that was brought on so often, and given up for others, is left off: so reach() ends whatever
// rounding does to the costs.
constexpr char kMostReaches = 8;

// In a larger star only whole pieces are moved: to try every tetrahedron takes the square of their number.
constexpr std::size_t kWideStar = 400;

// Visits of tetrahedra that a labelling may take, for each site. Surfaces take a few hundred, two sides that
// confuse the layers of thin walls up to 2,400.
constexpr std::int64_t kMostVisits = 10000;

// A site around which so often something was stripped off is stripped as well.
constexpr char kMostLooks = 3;

// A fold less may be a pinch more, and the other way round; few last longer than this.
constexpr int kUnfoldTurns = 8;

// So many flat tetrahedra on each other are a flat cloud.
constexpr std::size_t kFlatPile = 16;

// A star of no more tetrahedra is searched as a list.
constexpr std::size_t kQuickStar = 96;

}  // namespace

ManifoldLabels::ManifoldLabels(const TetrahedralMesh& mesh, const SiteGeometry& geometry,
                               const LabelCosts& costs, std::vector<char>& inside, const Cancel& cancel)
    : mesh_(mesh),
      geometry_(geometry),
      costs_(costs),
      cancel_(cancel),
      inside_(inside),
      seed_(geometry.near.size(), kNone),
      census_(geometry.near.size()),
      exempt_(geometry.near.size(), 0),
      seen_(mesh.size(), 0) {
  for (std::size_t t = 0; t < mesh.size(); ++t)
    for (Index v : mesh.tets.corners[t])
      if (v != kNone) seed_[v] = static_cast<Index>(t);
  for (double c : costs.off) site_cost_ += c / static_cast<double>(costs.off.size());
}

// Where all sites are neighbours, as on a moment curve, a star has as many tetrahedra as there are sites, and
// the moves at a site are as many and look at as many stars each: the repair would take the fourth power. The
// visits are counted by one thread, so this comes at the same move for any number of threads.
bool ManifoldLabels::spent() const {
  return counts_.visits > kMostVisits * static_cast<std::int64_t>(seed_.size());
}

ManifoldLabels::Census ManifoldLabels::census(Index v) {
  ++stamp_;
  Census result;
  star_.clear(), first_.clear();
  waiting_.assign(1, seed_[v]);
  // Ends: a tetrahedron is searched from once, and waits no more often than it has neighbours.
  while (!waiting_.empty()) {
    const Index start = waiting_.back();
    waiting_.pop_back();
    if (seen_[start] == stamp_) continue;
    const char label = inside_[start];
    ++(label ? result.inside : result.outside);
    first_.push_back(star_.size());
    seen_[start] = stamp_;
    star_.push_back(start);
    for (std::size_t next = star_.size() - 1; next < star_.size(); ++next) {
      const Index t = star_[next];
      const int own = corner(t, v);
      for (int k = 0; k < 4; ++k) {
        if (k == own) continue;
        const Index u = mesh_.tets.neighbours[t][k];
        if (seen_[u] == stamp_) continue;
        if (inside_[u] == label) {
          seen_[u] = stamp_;
          star_.push_back(u);
        } else {
          waiting_.push_back(u);
        }
      }
    }
  }
  first_.push_back(star_.size());
  counts_.visits += static_cast<std::int64_t>(star_.size());
  return result;
}

// Are there tetrahedra of both labels around an edge, but for t?
bool ManifoldLabels::mixed(Index t, int a, int b) {
  int labels = 0;
  around_edge(t, a, b, [&](Index u) { return (labels |= inside_[u] ? 1 : 2) != 3; });
  return labels == 3;
}

// What the census of v is now that t, a tetrahedron of its star, has changed sides, where it was plain
// before. On a small sphere around v its two parts were discs, so that what t did to them shows where their
// common border, a simple curve, meets t's triangle: whole stars need not be searched.
ManifoldLabels::Census ManifoldLabels::census_of_flip(Index v, Index t, const Census& before) {
  const bool now = inside_[t], was = !now;
  const int own = corner(t, v);
  int border = 0, apart = own;
  for (int k = 0; k < 4; ++k)
    if (k != own && (inside_[mesh_.tets.neighbours[t][k]] != 0) != was) ++border, apart = k;
  int rest = 1, gain = 1;  // pieces of the label it had, and of the other
  if (border == 3) {
    rest = 0;
  } else if (border == 1) {
    rest = mixed(t, own, apart) ? 2 : 1;  // the curve meets the triangle's far corner as well: it cuts
  } else if (border == 0) {
    int met = 0;
    for (int k = 0; k < 4; ++k) met += k != own && mixed(t, own, k);
    rest = std::max(1, met);
    gain = (now ? before.inside : before.outside) + 1;
  }
  return now ? Census{gain, rest} : Census{rest, gain};
}

// The census of v now that a move has been made; census_ is what was before it.
ManifoldLabels::Census ManifoldLabels::census_after(Index v, const Move& move) {
  if (!census_[v].plain() || move.size() > 2) return census(v);
  const auto has = [&](Index t) { return mesh_.tets.corners[t][corner(t, v)] == v; };
  if (move.size() == 1 || !has(move[1])) return census_of_flip(v, move[0], census_[v]);
  if (!has(move[0])) return census_of_flip(v, move[1], census_[v]);
  for (const auto& [first, second] : {std::pair(move[0], move[1]), std::pair(move[1], move[0])}) {
    inside_[second] = !inside_[second];  // one after the other
    const Census between = census_of_flip(v, first, census_[v]);
    inside_[second] = !inside_[second];
    if (between.plain()) return census_of_flip(v, second, between);
  }
  return census(v);
}

// The census of a site whose star is small, without the members: for several threads at once. The star is
// searched as a list; false: it is too long for that.
bool ManifoldLabels::quick_census(Index v, Census& result) const {
  std::array<Index, kQuickStar> star, waiting;
  std::size_t size = 0, waits = 1;
  waiting[0] = seed_[v];
  result = {};
  const auto met = [&](Index t) {
    const auto end = star.begin() + static_cast<std::ptrdiff_t>(size);
    return std::find(star.begin(), end, t) != end;
  };
  while (waits > 0) {  // ends as census() does
    const Index start = waiting[--waits];
    if (met(start)) continue;
    if (size == kQuickStar) return false;
    const char label = inside_[start];
    ++(label ? result.inside : result.outside);
    std::size_t next = size;
    star[size++] = start;
    for (; next < size; ++next) {
      const Index t = star[next];
      const int own = corner(t, v);
      for (int k = 0; k < 4; ++k) {
        const Index u = mesh_.tets.neighbours[t][k];
        if (k == own || met(u)) continue;
        if (size == kQuickStar || waits == kQuickStar) return false;
        (inside_[u] == label ? star[size++] : waiting[waits++]) = u;
      }
    }
  }
  return true;
}

// Of every site; returns those where the surface is not a disc.
std::vector<Index> ManifoldLabels::take_census() {
  const std::vector<Sheets> sheets = surface_sheets(mesh_, inside_, seed_.size());
  std::vector<char> large(seed_.size(), 0);
  parallel_each(seed_.size(), [&](std::size_t v) {
    if (seed_[v] == kNone) return;
    if (sheets[v] == Sheets::None)
      census_[v] = inside_[seed_[v]] ? Census{1, 0} : Census{0, 1};
    else if (sheets[v] == Sheets::Disc)
      census_[v] = {1, 1};
    else
      large[v] = !quick_census(static_cast<Index>(v), census_[v]);
  });
  std::vector<Index> singular;
  for (std::size_t v = 0; v < seed_.size(); ++v) {
    if (seed_[v] == kNone) continue;
    if (large[v]) census_[v] = census(static_cast<Index>(v));
    if (this->singular(static_cast<Index>(v))) singular.push_back(static_cast<Index>(v));
  }
  return singular;
}

bool ManifoldLabels::allowed(const Move& move) const {
  return !move.empty() &&
         std::none_of(move.begin(), move.end(), [&](Index t) { return mesh_.tets.infinite(t); });
}

// Is one of the tetrahedra beside one of the other label? Else it would start an island.
bool ManifoldLabels::grows(const Move& move) const {
  for (Index t : move)
    for (Index u : mesh_.tets.neighbours[t])
      if (inside_[u] != inside_[t]) return true;
  return false;
}

double ManifoldLabels::flip_cost(Index t) const {
  double cost = inside_[t] ? costs_.hold[t] : -costs_.hold[t];
  for (int k = 0; k < 4; ++k)
    cost += inside_[mesh_.tets.neighbours[t][k]] == inside_[t] ? costs_.facet[t][k] : -costs_.facet[t][k];
  return cost;
}

// No less than a move would cost at best, without a look at the stars: those of sites far from all others
// are large. What a surplus piece costs goes in with `piece`.
double ManifoldLabels::least_cost(const Move& move, double piece) {
  double cost = 0;
  for (Index t : move) {
    cost += flip_cost(t);
    inside_[t] = !inside_[t];
  }
  for (Index t : move) inside_[t] = !inside_[t];
  for (Index v : sites_of(move))
    cost -= piece * census_[v].surplus() + (census_[v].off() ? costs_.off[v] : 0);
  return cost;
}

// What a move would change. Leaves the labels as they are.
ManifoldLabels::Effect ManifoldLabels::effect(const Move& move) {
  cancel_();
  Effect e;
  int facets = 0;
  touched_.clear();
  for (Index t : move) {
    e.cost += flip_cost(t);
    for (Index u : mesh_.tets.neighbours[t]) facets += inside_[u] == inside_[t] ? 1 : -1;
    inside_[t] = !inside_[t];
    for (Index v : mesh_.tets.corners[t])
      if (std::find(touched_.begin(), touched_.end(), v) == touched_.end()) touched_.push_back(v);
  }
  // With all sheets apart the surface has three edges for two facets: V - E + F = V - F / 2.
  e.euler = -facets / 2;
  for (Index v : touched_) {
    const Census now = census_after(v, move);
    e.surplus += now.surplus() - census_[v].surplus();
    e.euler += now.sheets() - census_[v].sheets();
    e.cost += (static_cast<int>(now.off()) - static_cast<int>(census_[v].off())) * costs_.off[v];
  }
  for (Index t : move) inside_[t] = !inside_[t];
  return e;
}

// The corners of a move's tetrahedra.
const std::vector<Index>& ManifoldLabels::sites_of(const Move& move) {
  touched_.clear();
  for (Index t : move)
    touched_.insert(touched_.end(), mesh_.tets.corners[t].begin(), mesh_.tets.corners[t].end());
  unique_sorted(touched_);
  return touched_;
}

// Makes a move, and adds the sites that are singular then to a list. Returns the censuses of sites_of(move)
// before it.
std::vector<ManifoldLabels::Census> ManifoldLabels::apply(const Move& move, std::vector<Index>& singular) {
  cancel_();
  for (Index t : move) inside_[t] = !inside_[t];
  std::vector<Census> before;
  for (Index v : sites_of(move)) {
    before.push_back(census_[v]);
    census_[v] = census_after(v, move);
    if (this->singular(v)) singular.push_back(v);
  }
  return before;
}

// Calls visit(u) for all tetrahedra of whose flip the effect may be another after a move: those that share an
// edge with it, and where a site has come on or off or is singular, all of its star.
template <class Visit>
void ManifoldLabels::each_concerned(const Move& move, const std::vector<Census>& before, const Visit& visit) {
  for (Index t : move) {
    visit(t);
    for (int a = 0; a < 4; ++a)
      for (int b = a + 1; b < 4; ++b) around_edge(t, a, b, [&](Index u) { return visit(u), true; });
  }
  const std::vector<Index> sites = sites_of(move);
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const Index v = sites[i];
    if (before[i].off() == census_[v].off() && before[i].plain() && census_[v].plain()) continue;
    census(v);
    for (Index u : star_) visit(u);
  }
}

// The shortest way through the star of v from one piece of it, star[begin, end), to another of the same
// label.
ManifoldLabels::Move ManifoldLabels::bridge(Index v, const std::vector<Index>& star, std::size_t begin,
                                            std::size_t end) {
  const char label = inside_[star[begin]];
  std::vector<Index> queue(star.begin() + static_cast<std::ptrdiff_t>(begin),
                           star.begin() + static_cast<std::ptrdiff_t>(end));
  const std::size_t own = queue.size();
  std::vector<std::size_t> from(own, 0);
  ++stamp_;
  for (Index t : queue) seen_[t] = stamp_;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const Index t = queue[i];
    const int skip = corner(t, v);
    for (int k = 0; k < 4; ++k) {
      const Index u = mesh_.tets.neighbours[t][k];
      if (k == skip || seen_[u] == stamp_) continue;
      if (inside_[u] == label) {
        counts_.visits += static_cast<std::int64_t>(queue.size());
        Move move;
        for (std::size_t j = i; j >= own; j = from[j]) move.push_back(queue[j]);
        return move;
      }
      seen_[u] = stamp_;
      if (mesh_.tets.infinite(u)) continue;
      queue.push_back(u);
      from.push_back(i);
    }
  }
  counts_.visits += static_cast<std::int64_t>(queue.size());
  return {};
}

// What might help at a singular site: to give up a piece of its star or a tetrahedron of one, to join two
// pieces, to relabel any tetrahedron, or to take the site off the surface. `erode`: only those that take from
// the inside.
std::vector<ManifoldLabels::Move> ManifoldLabels::moves_at(Index v, bool erode) {
  std::vector<Move> moves;
  if (spent()) return moves;
  const Census now = census(v);
  const std::vector<Index> star = star_;
  const std::vector<std::size_t> first = first_;
  Move all_in, all_out;
  for (std::size_t i = 0; i + 1 < first.size() && !spent(); ++i) {
    Move piece(star.begin() + static_cast<std::ptrdiff_t>(first[i]),
               star.begin() + static_cast<std::ptrdiff_t>(first[i + 1]));
    const bool in = inside_[piece[0]];
    Move& all = in ? all_in : all_out;
    all.insert(all.end(), piece.begin(), piece.end());
    if ((in ? now.inside : now.outside) < 2) continue;
    if (!in || !erode) moves.push_back(bridge(v, star, first[i], first[i + 1]));
    if (in || !erode) moves.push_back(std::move(piece));
  }
  const bool wide = star.size() > kWideStar;
  if (!wide)
    for (Index t : all_in) moves.push_back({t});
  moves.push_back(std::move(all_in));
  if (!erode) {
    if (!wide)
      for (Index t : all_out) moves.push_back({t});
    moves.push_back(std::move(all_out));
  }
  return moves;
}

// The best of them, the first of those that cost the same. They are looked at by what they cost at least, as
// few need it then.
ManifoldLabels::Move ManifoldLabels::best_move(Index v, bool erode) {
  std::vector<Move> moves = moves_at(v, erode);
  std::vector<std::pair<double, std::size_t>> least;
  for (std::size_t i = 0; i < moves.size(); ++i)
    if (allowed(moves[i])) least.push_back({least_cost(moves[i], site_cost_), i});
  std::sort(least.begin(), least.end());
  const std::size_t none = moves.size();
  std::pair<double, std::size_t> best{std::numeric_limits<double>::infinity(), none};
  for (const auto& [bound, i] : least) {
    if (bound > best.first) break;
    if (spent()) return {};
    const Effect e = effect(moves[i]);
    double cost = e.cost + e.surplus * site_cost_;
    if (!erode) {
      if (e.surplus >= 0) continue;
      cost += std::max(0, -e.euler / 2) * kHandlePrice * site_cost_;
    }
    best = std::min(best, {cost, i});
  }
  return best.second == none ? Move{} : std::move(moves[best.second]);
}

// Until no site of the list, or that became singular on the way, is singular. Those where nothing lowers the
// number of surplus pieces are left on stuck_; with `erode` there are none, as a site that has surplus pieces
// has tetrahedra inside. Ends: a move lowers the number of surplus pieces of all sites, or with `erode` that
// of tetrahedra inside, and a turn without a move leaves nothing to do.
void ManifoldLabels::lower(std::vector<Index> singular, bool erode) {
  stuck_.clear();
  std::vector<Index> next;
  while (!singular.empty()) {
    unique_sorted(singular);
    next.clear();
    for (Index v : singular) {
      if (!this->singular(v)) continue;
      const Move move = best_move(v, erode);
      if (move.empty()) {
        stuck_.push_back(v);
        continue;
      }
      ++(erode ? counts_.erosions : counts_.repairs);
      apply(move, next);
    }
    singular.swap(next);
  }
}

// Takes all that is inside away around singular sites, many at once; what that makes singular comes next.
// Such a site stays off, as nothing comes inside, and one that is looked at often goes as well: so it ends,
// and no star is looked at more than a few times.
void ManifoldLabels::strip() {
  std::vector<char> looks(seed_.size(), 0);
  for (std::vector<Index> singular = take_census(), next; !singular.empty(); singular.swap(next)) {
    cancel_();
    Move taken;
    for (Index v : singular) {
      census(v);
      for (Index t : star_)
        if (inside_[t]) inside_[t] = 0, taken.push_back(t);
    }
    counts_.stripped += static_cast<std::int64_t>(singular.size());
    next.clear();
    const std::vector<Index> sites = sites_of(taken);
    for (Index v : sites) {
      census_[v] = census(v);
      if (this->singular(v) || ++looks[v] == kMostLooks) next.push_back(v);
    }
  }
}

void ManifoldLabels::repair(std::vector<char> exempt) {
  if (!exempt.empty()) exempt_ = std::move(exempt);
  counts_.islands += drop_islands(mesh_, geometry_, inside_);
  std::vector<Index> singular = take_census();
  counts_.singular = static_cast<std::int64_t>(singular.size());
  lower(std::move(singular), false);
  lower(std::move(stuck_), true);
  if (spent()) strip();
  if (counts_.singular == 0) return;
  const std::int64_t islands = drop_islands(mesh_, geometry_, inside_);
  counts_.islands += islands;
  if (islands > 0) take_census();
}

void ManifoldLabels::warp(const std::vector<char>& aim) {
  std::vector<Index> front, next, none;
  for (std::size_t t = 0; t < mesh_.size(); ++t)
    if (inside_[t] != aim[t] && !mesh_.tets.infinite(static_cast<Index>(t)))
      front.push_back(static_cast<Index>(t));
  // Ends: every step leaves a difference from `aim` less, and what is looked at again is beside a step.
  while (!front.empty()) {
    unique_sorted(front);
    next.clear();
    for (Index t : front) {
      const Move move{t};
      if (inside_[t] == aim[t] || !grows(move)) continue;
      if (spent()) return;
      const Effect e = effect(move);
      if (e.surplus != 0 || e.euler != 0) continue;
      const std::vector<Census> before = apply(move, none);
      ++counts_.warped;
      each_concerned(move, before, [&](Index u) {
        if (inside_[u] != aim[u] && !mesh_.tets.infinite(u)) next.push_back(u);
      });
    }
    front.swap(next);
  }
}

// Has the surface facets on both sides of a flat tetrahedron? Where all that is inside there is flat, as in a
// flat cloud or a sheet on a plane, there is no other surface.
bool ManifoldLabels::folded(Index t) const {
  const int side = mesh_.flat[t];
  if (side == 0) return false;
  int met = 0;
  for (int k = 0; k < 4; ++k)
    if (inside_[mesh_.tets.neighbours[t][k]] != inside_[t]) met |= (side >> k & 1) ? 1 : 2;
  if (met != 3) return false;
  if (!inside_[t]) return true;
  std::array<Index, kFlatPile> pile{t};
  std::size_t size = 1;
  for (std::size_t i = 0; i < size; ++i)
    for (Index u : mesh_.tets.neighbours[pile[i]]) {
      if (!inside_[u]) continue;
      if (!mesh_.flat[u]) return true;
      if (size < kFlatPile && std::find(pile.begin(), pile.begin() + size, u) == pile.begin() + size)
        pile[size++] = u;
    }
  return false;
}

// How many there are among some tetrahedra and those beside them.
int ManifoldLabels::folds_around(const Move& move) const {
  std::vector<Index> met = move;
  for (Index t : move)
    met.insert(met.end(), mesh_.tets.neighbours[t].begin(), mesh_.tets.neighbours[t].end());
  unique_sorted(met);
  return static_cast<int>(std::count_if(met.begin(), met.end(), [&](Index t) { return folded(t); }));
}

// How many there would be more after a move.
int ManifoldLabels::more_folds(const Move& move) {
  const int before = folds_around(move);
  for (Index t : move) inside_[t] = !inside_[t];
  const int after = folds_around(move);
  for (Index t : move) inside_[t] = !inside_[t];
  return after - before;
}

// The site that lies in the facet of a flat tetrahedron opposite to it, if that facet alone is on the surface
// and the surface comes to the site from the other side: before the sites were perturbed, it touched itself
// there. Else kNone.
Index ManifoldLabels::pinch(Index t) const {
  const int side = mesh_.flat[t];
  int largest = 0;
  while (largest < 4 && side != 1 << largest) ++largest;
  if (largest == 4) return kNone;  // none is as large as the others together
  for (int k = 0; k < 4; ++k)
    if ((inside_[mesh_.tets.neighbours[t][k]] != inside_[t]) != (k == largest)) return kNone;
  const Index v = mesh_.tets.corners[t][largest];
  return census_[v].off() ? kNone : v;
}

// What takes a fold or a pinch at a flat tetrahedron: that it changes sides, and of a pinch, that the site
// goes over to the sheet that it lies in.
ManifoldLabels::Move ManifoldLabels::best_unfold(Index t) {
  const auto helps = [&](const Move& move, int folds) {
    if (!allowed(move) || !grows(move) || more_folds(move) >= folds) return false;
    const Effect e = effect(move);
    return e.surplus == 0 && e.euler == 0 && (folds <= 0 || e.cost < site_cost_);
  };
  Move move{t};
  if (folded(t)) return helps(move, 0) ? move : Move{};
  const Index v = pinch(t);
  if (v == kNone) return {};
  census(v);
  for (Index u : star_)
    if (inside_[u] != inside_[t]) move.push_back(u);
  return helps(move, 2) ? move : Move{};
}

void ManifoldLabels::unfold() {
  std::vector<Index> flat, none;
  for (std::size_t t = 0; t < mesh_.size(); ++t)
    if (mesh_.flat[t]) flat.push_back(static_cast<Index>(t));
  bool moved = true;
  for (int turn = 0; moved && turn < kUnfoldTurns; ++turn) {
    moved = false;
    for (Index t : flat) {
      if (spent()) return;
      const Move move = best_unfold(t);
      if (move.empty()) continue;
      apply(move, none);
      ++counts_.unfolded;
      moved = true;
    }
  }
}

// The cheapest way to bring v on for less than this share of its worth.
ManifoldLabels::Move ManifoldLabels::best_reach(Index v, double share) {
  Move best;
  double best_cost = -(1 - share) * costs_.off[v];
  const auto consider = [&](Move move) {
    if (!allowed(move) || !grows(move) || least_cost(move, 0) >= best_cost) return;
    const Effect e = effect(move);
    if (e.surplus != 0 || e.euler != 0 || e.cost >= best_cost || more_folds(move) > 0) return;
    best_cost = e.cost, best = std::move(move);
  };
  census(v);
  const std::vector<Index> star = star_;
  for (Index t : star) {
    if (spent()) return {};
    consider({t});
    const int own = corner(t, v);
    for (int k = 0; k < 4; ++k)
      if (k != own && mesh_.tets.neighbours[t][k] > t) consider({t, mesh_.tets.neighbours[t][k]});
  }
  return best;
}

void ManifoldLabels::reach() {
  std::vector<Index> none;
  std::vector<char> changed(seed_.size());  // something about its star, since it was looked at in vain
  std::vector<char> reaches(seed_.size(), 0);
  for (double share = kFirstShare;;) {
    std::fill(changed.begin(), changed.end(), 1);
    for (bool moved = true; moved;) {
      moved = false;
      for (std::size_t v = 0; v < seed_.size(); ++v) {
        if (spent()) return;
        if (seed_[v] == kNone || !changed[v] || !census_[v].off() || reaches[v] == kMostReaches) continue;
        changed[v] = 0;
        const Move move = best_reach(static_cast<Index>(v), share);
        if (move.empty()) continue;
        const std::vector<Census> before = apply(move, none);
        ++counts_.reached, ++reaches[v];
        moved = true;
        each_concerned(move, before, [&](Index t) {
          for (Index w : mesh_.tets.corners[t])
            if (w != kNone) changed[w] = 1;
        });
      }
    }
    if (share == 1) break;
    share = std::min(1.0, 2 * share);
  }
}

}  // namespace filmsticking
