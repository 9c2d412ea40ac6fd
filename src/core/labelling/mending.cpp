// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/mending.h"

#include <algorithm>
#include <utility>

#include "labelling/repair.h"

namespace filmsticking {
namespace {

// The cost of a cap is known when its surroundings are at rest. More rounds than a tetrahedron is wide lead
// away from it.
constexpr int kRelaxRounds = 10;
// Sites that a filled tunnel may bury. Chance leaves no sample between the sides of a wall; samples that line
// a tunnel show that it is one.
constexpr int kMostBuried = 1;
// What a move is worth then, in sites off the surface: more than rounding.
constexpr double kRelaxGain = 1e-6;

// A part that is relabelled, and all that follows it, until it is kept or undone.
class Trial {
 public:
  Trial(Labelling& labelling, double cost) : labelling_(labelling), cost_(cost) {}

  Effect make(const Move& move, std::vector<Index>& singular) {
    Labelling::Made made = labelling_.make(move, &singular);
    const Effect e = made.effect;
    cost_ += e.cost, euler_ += e.euler, off_ += e.off;
    changed_.insert(changed_.end(), move.begin(), move.end());
    moves_.push_back({move, std::move(made.before)});
    return e;
  }

  // Makes the surface a manifold again. False: no move does, or as many change as no mend needs. Ends: every
  // move lowers the number of surplus pieces.
  bool repair(std::vector<Index> singular, std::size_t most) {
    std::vector<Index> next;
    while (!singular.empty()) {
      unique_sorted(singular);
      next.clear();
      for (Index v : singular) {
        if (!labelling_.singular(v)) continue;
        const Move move = best_repair(labelling_, v);
        if (move.empty() || changed_.size() > most) return false;
        make(move, next);
      }
      singular.swap(next);
    }
    return true;
  }

  // Makes the moves around it that keep the topology and lower the cost.
  void come_to_rest() {
    std::vector<Index> front = changed_, next, none;
    for (int round = 0; round < kRelaxRounds && !front.empty(); ++round) {
      next = front;
      for (Index t : front)
        next.insert(next.end(), labelling_.neighbours(t).begin(), labelling_.neighbours(t).end());
      unique_sorted(next);
      front.clear();
      for (Index t : next) {
        const Move move{t};
        if (!labelling_.allowed(move) || !labelling_.grows(move)) continue;
        const Effect e = labelling_.effect(move);
        if (e.surplus != 0 || e.euler != 0 || e.cost > -kRelaxGain * labelling_.site_cost()) continue;
        make(move, none);
        front.push_back(t);
      }
    }
  }

  // How many labels there are among the changed tetrahedra and beside them.
  int labels_around() const {
    bool present[2] = {false, false};
    for (Index t : changed_) {
      present[labelling_.label(t) ? 1 : 0] = true;
      for (Index u : labelling_.neighbours(t)) present[labelling_.label(u) ? 1 : 0] = true;
    }
    return present[0] + present[1];
  }

  void undo() {
    for (; !moves_.empty(); moves_.pop_back()) labelling_.unmake(moves_.back().first, moves_.back().second);
  }

  double cost() const { return cost_; }
  int euler() const { return euler_; }
  int off() const { return off_; }
  const Move& changed() const { return changed_; }

 private:
  Labelling& labelling_;
  double cost_;
  int euler_ = 0, off_ = 0;
  Move changed_;
  std::vector<std::pair<Move, std::vector<Census>>> moves_;  // with the censuses before each
};

}  // namespace

std::int64_t Mending::name_pieces() {
  labelling.exempt_no_more();
  pieces.name(labelling);
  return pieces.count();
}

void Mending::try_one(const Move& part, const MendTerms& terms) {
  const auto worth = [&](int handles, int fewer) {
    return (terms.tunnel * handles + terms.tear * fewer) * labelling.site_cost();
  };
  const bool fills = !labelling.label(part.front());
  const int pieces_before = pieces.count_around(labelling, part);
  Trial trial(labelling, terms.size * static_cast<double>(part.size()) * labelling.site_cost());
  std::vector<Index> singular;
  const Effect alone = trial.make(part, singular);
  const bool in_vain = !terms.relax && alone.surplus == 0 && pieces_before <= 2 &&
                       (alone.euler <= 0 || alone.cost >= worth(alone.euler / 2, 0));
  if (!in_vain && trial.repair(std::move(singular), 4 * part.size() + 16) &&
      !pieces.parted(labelling, trial.changed(), 0, terms.look) &&
      !pieces.parted(labelling, trial.changed(), 1, terms.look)) {
    // Components of the surface are pieces of both labels less one; handles, components less half of the
    // Euler characteristic.
    const int fewer = pieces.count_around(labelling, trial.changed()) - trial.labels_around();
    const int handles = trial.euler() / 2 + fewer;
    const bool mends = handles >= 0 && fewer >= 0 && handles + fewer > 0;
    if (mends && terms.relax && trial.cost() >= worth(handles, fewer)) trial.come_to_rest();
    const bool lined = fills && handles > 0 && trial.off() > kMostBuried;
    if (mends && !lined && trial.cost() < worth(handles, fewer)) {
      pieces.unite_around(labelling, trial.changed());
      labelling.counts.tunnels += handles > 0;
      labelling.counts.tears += fewer > 0;
      return;
    }
  }
  trial.undo();
}

void Mending::try_all(const std::vector<Move>& parts, char label, const MendTerms& terms) {
  for (const Move& part : parts) {
    labelling.stop_if_cancelled();
    if (labelling.spent()) return;
    const bool whole =
        std::all_of(part.begin(), part.end(), [&](Index t) { return labelling.label(t) == label; });
    if (whole && labelling.grows(part)) try_one(part, terms);
  }
}

std::int64_t Mending::handles() const {
  std::int64_t euler2 = 0;  // twice the Euler characteristic: V - F / 2, with three edges for two facets
  for (std::size_t v = 0; v < labelling.sites(); ++v)
    if (const Census& c = labelling.census(static_cast<Index>(v)); !c.off())
      euler2 += 2 * std::int64_t{c.sheets()};
  for (std::size_t s = 0; s < labelling.mesh().size(); ++s) {
    const Index t = static_cast<Index>(s);
    if (labelling.label(t))
      for (Index u : labelling.neighbours(t)) euler2 -= !labelling.label(u);
  }
  // Not genus(): through infinity the characteristic may be odd, and the halves are then rounded otherwise.
  return pieces.count() - 1 - euler2 / 4;
}

}  // namespace filmsticking
