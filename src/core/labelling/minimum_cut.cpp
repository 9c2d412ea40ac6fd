// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/minimum_cut.h"

#include <algorithm>
#include <deque>

#include "geometry/parallel.h"

namespace filmsticking {
namespace {

constexpr Index kTerminal = -2, kOrphan = -3;  // in place of a parent arc

class Solver {
 public:
  explicit Solver(CutGraph& graph)
      : g_(graph),
        n_(static_cast<Index>(graph.terminal.size())),
        tree_(n_),
        parent_(n_),
        active_flag_(n_),
        time_(n_),
        distance_(n_) {}

  // Ends: a path between the trees raises the flow, which is whole and at most what the terminals hold.
  // Without one, a node less is active, and nodes become active again only with a path.
  std::vector<char> solve(const std::vector<char>& fallback, const Cancel& cancel) {
    push_across();
    plant();
    Index current = kNone;
    for (std::uint64_t turns = 0;;) {
      if (current == kNone || tree_[current] == 0) current = next_active();
      if (current == kNone) break;
      if (++turns % 4096 == 0) cancel();
      const Index meeting = grow(current);  // an arc from the source's tree to the sink's
      ++clock_;
      if (meeting == kNone) {
        current = kNone;
        continue;
      }
      augment(meeting);
      adopt();
    }
    std::vector<char> side(n_);
    parallel_each(side.size(), [&](std::size_t i) { side[i] = tree_[i] == 0 ? fallback[i] : tree_[i] > 0; });
    return side;
  }

 private:
  // Most of the flow goes from source to sink over a single arc. Several threads push it, each in a chunk of
  // the nodes. The labels do not depend on the order: every maximum flow leaves the same nodes that the
  // source reaches, and the same that reach the sink.
  void push_across() {
    constexpr std::size_t kNodes = 16384;
    parallel_chunks(tree_.size(), kNodes, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (Index i = static_cast<Index>(begin); i < static_cast<Index>(end); ++i)
        for (Index k = 0; k < 4 && g_.terminal[i] > 0; ++k) {
          const Index back = g_.mirror[i][k], j = back / 4;
          if (j < static_cast<Index>(begin) || j >= static_cast<Index>(end) || g_.terminal[j] >= 0) continue;
          const std::int64_t flow =
              std::min({std::int64_t{g_.capacity[i][k]}, g_.terminal[i], -g_.terminal[j]});
          g_.capacity[i][k] -= static_cast<std::int32_t>(flow),
              capacity(back) += static_cast<std::int32_t>(flow);
          g_.terminal[i] -= flow, g_.terminal[j] += flow;
        }
    });
  }

  // Both trees begin at the nodes with terminals. A node is active only if it can grow.
  void plant() {
    const auto root = [&](Index i) { return g_.terminal[i] > 0 ? 1 : g_.terminal[i] < 0 ? -1 : 0; };
    parallel_each(tree_.size(), [&](std::size_t node) {
      const Index i = static_cast<Index>(node);
      tree_[i] = static_cast<signed char>(root(i));
      parent_[i] = kNone, active_flag_[i] = 0, time_[i] = 0, distance_[i] = 0;
      if (tree_[i] == 0) return;
      parent_[i] = kTerminal;
      distance_[i] = 1;
      for (Index k = 0; k < 4; ++k)
        if (root(g_.mirror[i][k] / 4) != tree_[i] && outward(tree_[i], 4 * i + k) > 0) active_flag_[i] = 1;
    });
    for (Index i = 0; i < n_; ++i)
      if (active_flag_[i]) active_.push_back(i);
  }

  std::int32_t& capacity(Index arc) { return g_.capacity[arc / 4][arc % 4]; }
  Index mirror(Index arc) const { return g_.mirror[arc / 4][arc % 4]; }
  // Towards the sink along the arc in the source's tree, against it in the sink's.
  std::int64_t outward(int tree, Index arc) { return tree > 0 ? capacity(arc) : capacity(mirror(arc)); }

  void activate(Index i) {
    if (!active_flag_[i]) active_flag_[i] = 1, active_.push_back(i);
  }
  Index next_active() {
    while (!active_.empty()) {
      const Index i = active_.front();
      active_.pop_front();
      active_flag_[i] = 0;
      if (tree_[i] != 0) return i;
    }
    return kNone;
  }

  Index grow(Index i) {
    for (Index k = 0; k < 4; ++k) {
      const Index arc = 4 * i + k;
      if (outward(tree_[i], arc) <= 0) continue;
      const Index j = mirror(arc) / 4;
      if (tree_[j] == 0) {
        tree_[j] = tree_[i];
        parent_[j] = mirror(arc);
        time_[j] = time_[i];
        distance_[j] = distance_[i] + 1;
        activate(j);
      } else if (tree_[j] != tree_[i]) {
        activate(i);
        return tree_[i] > 0 ? arc : mirror(arc);
      } else if (time_[j] <= time_[i] && distance_[j] > distance_[i]) {
        parent_[j] = mirror(arc);  // a shorter path to the terminal
        time_[j] = time_[i];
        distance_[j] = distance_[i] + 1;
      }
    }
    return kNone;
  }

  // Ends, as distance_to_terminal() does: the parents form trees, without rings.
  void augment(Index meeting) {
    std::int64_t flow = capacity(meeting);
    Index i = meeting / 4;
    for (; parent_[i] != kTerminal; i = mirror(parent_[i]) / 4)
      flow = std::min<std::int64_t>(flow, capacity(mirror(parent_[i])));
    flow = std::min(flow, g_.terminal[i]);
    for (i = mirror(meeting) / 4; parent_[i] != kTerminal; i = mirror(parent_[i]) / 4)
      flow = std::min<std::int64_t>(flow, capacity(parent_[i]));
    flow = std::min(flow, -g_.terminal[i]);

    const auto pushed = static_cast<std::int32_t>(flow);  // no more than a capacity
    capacity(meeting) -= pushed, capacity(mirror(meeting)) += pushed;
    for (i = meeting / 4; parent_[i] != kTerminal;) {
      const Index up = mirror(parent_[i]), above = up / 4;
      capacity(parent_[i]) += pushed, capacity(up) -= pushed;
      if (capacity(up) == 0) orphan(i);
      i = above;
    }
    g_.terminal[i] -= flow;
    if (g_.terminal[i] == 0) orphan(i);
    for (i = mirror(meeting) / 4; parent_[i] != kTerminal;) {
      const Index down = parent_[i], above = mirror(down) / 4;
      capacity(down) -= pushed, capacity(mirror(down)) += pushed;
      if (capacity(down) == 0) orphan(i);
      i = above;
    }
    g_.terminal[i] += flow;
    if (g_.terminal[i] == 0) orphan(i);
  }

  void orphan(Index i) { parent_[i] = kOrphan, orphans_.push_back(i); }

  // The distance of j to the terminal of its tree, or 0 if an orphan cuts it from there. Marks the path with
  // the time, so that the next search stops at it.
  Index distance_to_terminal(Index j) {
    Index steps = 0, i = j;
    for (;;) {
      if (time_[i] == clock_) {
        steps += distance_[i];
        break;
      }
      ++steps;
      if (parent_[i] == kTerminal) {
        time_[i] = clock_, distance_[i] = 1;
        break;
      }
      if (parent_[i] == kOrphan || parent_[i] == kNone) return 0;
      i = mirror(parent_[i]) / 4;
    }
    Index mark = steps;
    for (i = j; time_[i] != clock_; i = mirror(parent_[i]) / 4) time_[i] = clock_, distance_[i] = mark--;
    return steps;
  }

  // Ends: an orphan that finds a parent has a path to a terminal without orphans, and stays adopted; the
  // others leave their tree.
  void adopt() {
    while (!orphans_.empty()) {
      const Index i = orphans_.front();
      orphans_.pop_front();
      const auto tree = tree_[i];
      Index best = kNone, least = 0;
      for (Index k = 0; k < 4; ++k) {
        const Index arc = 4 * i + k, j = mirror(arc) / 4;
        // The parent must be able to pass flow to i (source) or take it from i (sink).
        if (tree_[j] != tree || (tree > 0 ? capacity(mirror(arc)) : capacity(arc)) <= 0) continue;
        const Index d = distance_to_terminal(j);
        if (d > 0 && (best == kNone || d < least)) best = arc, least = d;
      }
      if (best != kNone) {
        parent_[i] = best;
        time_[i] = clock_;
        distance_[i] = least + 1;
        continue;
      }
      for (Index k = 0; k < 4; ++k) {
        const Index arc = 4 * i + k, j = mirror(arc) / 4;
        if (tree_[j] != tree) continue;
        if ((tree > 0 ? capacity(mirror(arc)) : capacity(arc)) > 0) activate(j);
        if (parent_[j] >= 0 && mirror(parent_[j]) / 4 == i) orphan(j);
      }
      tree_[i] = 0;
      parent_[i] = kNone;
    }
  }

  CutGraph& g_;
  const Index n_;
  UnsetVector<signed char> tree_;
  UnsetVector<Index> parent_;  // the arc from a node to its parent
  UnsetVector<char> active_flag_;
  UnsetVector<Index> time_, distance_;
  std::deque<Index> active_, orphans_;
  Index clock_ = 0;
};

}  // namespace

std::vector<char> minimum_cut(CutGraph& graph, const std::vector<char>& fallback, const Cancel& cancel) {
  return Solver(graph).solve(fallback, cancel);
}

}  // namespace filmsticking
