// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/minimum_cut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "support/clouds.h"

namespace filmsticking {
namespace {

struct RandomGraph {
  UnsetVector<std::array<Index, 4>> mirror;
  CutGraph graph{mirror, {}, {}};

  // Of up to 8 nodes; four arcs each, whose ends are paired at random.
  explicit RandomGraph(test::Random& random) {
    const int n = 2 * (2 + random.below(3));
    std::vector<Index> ends(static_cast<std::size_t>(4 * n));
    for (int i = 0; i < 4 * n; ++i) ends[i] = i;
    for (int i = 4 * n; i > 1; --i) std::swap(ends[i - 1], ends[random.below(i)]);
    mirror.resize(static_cast<std::size_t>(n));
    graph.capacity.assign(static_cast<std::size_t>(n), {0, 0, 0, 0});
    for (int i = 0; i < 4 * n; i += 2) {
      const Index a = ends[i], b = ends[i + 1];
      mirror[a / 4][a % 4] = b, mirror[b / 4][b % 4] = a;
      if (a / 4 != b / 4) graph.capacity[a / 4][a % 4] = graph.capacity[b / 4][b % 4] = random.below(20);
    }
    for (int i = 0; i < n; ++i) graph.terminal.push_back(random.below(41) - 20);
  }
  RandomGraph(const RandomGraph&) = delete;

  int size() const { return static_cast<int>(mirror.size()); }
};

std::int64_t cost(const CutGraph& graph, const std::vector<char>& side) {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < side.size(); ++i) {
    if (side[i] != (graph.terminal[i] > 0)) sum += std::abs(graph.terminal[i]);
    for (int k = 0; k < 4; ++k)
      if (side[i] && !side[graph.mirror[i][k] / 4]) sum += graph.capacity[i][k];
  }
  return sum;
}

// Of all cuts, one by one.
std::int64_t least_cost(const CutGraph& graph) {
  const int n = static_cast<int>(graph.mirror.size());
  std::int64_t least = INT64_MAX;
  for (int bits = 0; bits < 1 << n; ++bits) {
    std::vector<char> side(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) side[i] = bits >> i & 1;
    least = std::min(least, cost(graph, side));
  }
  return least;
}

TEST(MinimumCut, IsMinimal) {
  test::Random random(1);
  for (int turn = 0; turn < 300; ++turn) {
    RandomGraph g(random);
    const CutGraph original = g.graph;
    const std::vector<char> fallback(static_cast<std::size_t>(g.size()), 0);
    EXPECT_EQ(cost(original, minimum_cut(g.graph, fallback)), least_cost(original)) << turn;
  }
}

// What a cut leaves of the graph, with more added to the terminals, is cut as the whole graph is.
TEST(MinimumCut, AWarmStartIsMinimalToo) {
  test::Random random(2);
  for (int turn = 0; turn < 300; ++turn) {
    RandomGraph g(random);
    CutGraph whole = g.graph;
    const std::vector<char> fallback(static_cast<std::size_t>(g.size()), 0);
    minimum_cut(g.graph, fallback);
    for (int i = 0; i < g.size(); ++i) {
      const int more = whole.terminal[i] > 0 ? random.below(30) : -random.below(30);
      g.graph.terminal[i] += more, whole.terminal[i] += more;
    }
    EXPECT_EQ(cost(whole, minimum_cut(g.graph, fallback)), least_cost(whole)) << turn;
  }
}

TEST(MinimumCut, NodesThatNeitherTreeReachesTakeTheirFallback) {
  test::Random random(3);
  RandomGraph g(random);
  for (auto& terminal : g.graph.terminal) terminal = 0;
  std::vector<char> fallback(static_cast<std::size_t>(g.size()), 0);
  fallback[1] = 1;
  EXPECT_EQ(minimum_cut(g.graph, fallback), fallback);
}

TEST(MinimumCut, ACancelledCutThrows) {
  const int n = 20000;  // a path, along which flow is pushed node by node
  UnsetVector<std::array<Index, 4>> mirror(n);
  CutGraph graph{mirror, {}, {}};
  graph.capacity.assign(n, {1, 1, 0, 0});
  graph.terminal.assign(n, 0);
  for (Index i = 0; i < n; ++i) {
    const Index next = (i + 1) % n, last = (i + n - 1) % n;
    mirror[i] = {4 * next + 1, 4 * last, 4 * i + 3, 4 * i + 2};
  }
  graph.terminal[0] = 1, graph.terminal[n / 2] = -1;
  const std::atomic<bool> wish{true};
  EXPECT_THROW(minimum_cut(graph, std::vector<char>(n, 0), Cancel{&wish}), Cancelled);
}

}  // namespace
}  // namespace filmsticking
