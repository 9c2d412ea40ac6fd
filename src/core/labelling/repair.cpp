// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/repair.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include "labelling/energy.h"
#include "labelling/label_islands.h"

namespace filmsticking {
namespace {

// In a larger star only whole pieces are moved: all tetrahedra one by one take the square of their number.
constexpr std::size_t kWideStar = 400;

// A site around which the strip took something so often loses all of the inside as well.
constexpr char kMostLooks = 3;

Move part_of(const std::vector<Index>& star, std::size_t begin, std::size_t end) {
  return Move(star.begin() + static_cast<std::ptrdiff_t>(begin),
              star.begin() + static_cast<std::ptrdiff_t>(end));
}

// The shortest way through the star of v from one piece of it to another of the same label.
Move bridge(Labelling& labelling, Index v, std::vector<Index> piece) {
  Marks& seen = labelling.marks;
  const char label = labelling.label(piece[0]);
  const std::size_t own = piece.size();
  std::vector<Index>& queue = piece;
  std::vector<std::size_t> from(own, 0);
  seen.clear();
  for (Index t : queue) seen.add(t);
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const Index t = queue[i];
    const int skip = labelling.corner(t, v);
    for (int k = 0; k < 4; ++k) {
      const Index u = labelling.neighbours(t)[k];
      if (k == skip || seen.has(u)) continue;
      if (labelling.label(u) == label) {
        labelling.counts.visits += static_cast<std::int64_t>(queue.size());
        Move move;
        for (std::size_t j = i; j >= own; j = from[j]) move.push_back(queue[j]);
        return move;
      }
      seen.add(u);
      if (labelling.infinite(u)) continue;
      queue.push_back(u);
      from.push_back(i);
    }
  }
  labelling.counts.visits += static_cast<std::int64_t>(queue.size());
  return {};
}

// The moves to try at a singular site: a piece of its star or one tetrahedron changes labels, two pieces are
// joined, or the site leaves the surface. `erode`: only moves that take from the inside.
std::vector<Move> moves_at(Labelling& labelling, Index v, bool erode) {
  std::vector<Move> moves;
  if (labelling.spent()) return moves;
  const Census now = labelling.search_star(v);
  const std::vector<Index>& star = labelling.star();
  const std::vector<std::size_t>& first = labelling.pieces();
  Move all_in, all_out;
  for (std::size_t i = 0; i + 1 < first.size() && !labelling.spent(); ++i) {
    Move piece = part_of(star, first[i], first[i + 1]);
    const bool in = labelling.label(piece[0]);
    Move& all = in ? all_in : all_out;
    all.insert(all.end(), piece.begin(), piece.end());
    if ((in ? now.inside : now.outside) < 2) continue;
    if (!in || !erode) moves.push_back(bridge(labelling, v, piece));
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

// The cheapest of them, and of equals the first. In the order of their lower bounds, few need a look.
Move best_move(Labelling& labelling, Index v, bool erode) {
  std::vector<Move> moves = moves_at(labelling, v, erode);
  const double site_cost = labelling.site_cost();
  std::vector<std::pair<double, std::size_t>> least;
  for (std::size_t i = 0; i < moves.size(); ++i)
    if (labelling.allowed(moves[i])) least.push_back({labelling.least_cost(moves[i], site_cost), i});
  std::sort(least.begin(), least.end());
  const std::size_t none = moves.size();
  std::pair<double, std::size_t> best{std::numeric_limits<double>::infinity(), none};
  for (const auto& [bound, i] : least) {
    if (bound > best.first) break;
    if (labelling.spent()) return {};
    const Effect e = labelling.effect(moves[i]);
    double cost = e.cost + e.surplus * site_cost;
    if (!erode) {
      if (e.surplus >= 0) continue;
      cost += std::max(0, -e.euler / 2) * MovePrices().new_handle * site_cost;
    }
    best = std::min(best, {cost, i});
  }
  return best.second == none ? Move{} : std::move(moves[best.second]);
}

// Until no site of the list, or that a move made singular, is singular. Returns the sites where nothing
// lowers the number of surplus pieces; with `erode` there are none, as a site with surplus pieces has
// tetrahedra inside. Ends: a move lowers the number of surplus pieces, or with `erode` that of tetrahedra
// inside, and a turn without a move leaves nothing to do.
std::vector<Index> lower_surplus(Labelling& labelling, std::vector<Index> singular, bool erode) {
  std::vector<Index> stuck, next;
  while (!singular.empty()) {
    unique_sorted(singular);
    next.clear();
    for (Index v : singular) {
      if (!labelling.singular(v)) continue;
      const Move move = best_move(labelling, v, erode);
      if (move.empty()) {
        stuck.push_back(v);
        continue;
      }
      ++(erode ? labelling.counts.erosions : labelling.counts.repairs);
      labelling.apply(move, &next);
    }
    singular.swap(next);
  }
  return stuck;
}

// Takes all of the inside away around singular sites, many at once, and around the sites that this makes
// singular. Ends, and searches no star more than a few times: nothing comes inside, so such a site stays off,
// and one that has been looked at often is stripped as well.
void strip(Labelling& labelling) {
  std::vector<char> looks(labelling.sites(), 0);
  for (std::vector<Index> singular = labelling.take_census(), next; !singular.empty(); singular.swap(next)) {
    labelling.stop_if_cancelled();
    Move taken;
    for (Index v : singular) {
      labelling.search_star(v);
      for (Index t : labelling.star())
        if (labelling.label(t)) labelling.flip(t), taken.push_back(t);
    }
    labelling.counts.stripped += static_cast<std::int64_t>(singular.size());
    next.clear();
    for (Index v : labelling.recount(taken))
      if (labelling.singular(v) || ++looks[v] == kMostLooks) next.push_back(v);
  }
}

}  // namespace

Move best_repair(Labelling& labelling, Index v) { return best_move(labelling, v, false); }

void repair(Labelling& labelling, std::vector<char> exempt) {
  labelling.exempt(std::move(exempt));
  LabelCounts& counts = labelling.counts;
  counts.islands += drop_islands(labelling.mesh(), labelling.geometry(), labelling.labels());
  std::vector<Index> singular = labelling.take_census();
  counts.singular = static_cast<std::int64_t>(singular.size());
  std::vector<Index> stuck = lower_surplus(labelling, std::move(singular), false);
  lower_surplus(labelling, std::move(stuck), true);
  if (labelling.spent()) strip(labelling);
  if (counts.singular == 0) return;
  const std::int64_t islands = drop_islands(labelling.mesh(), labelling.geometry(), labelling.labels());
  counts.islands += islands;
  if (islands > 0) labelling.take_census();
}

}  // namespace filmsticking
