// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/disjoint_sets.h"

#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "support/clouds.h"

namespace filmsticking {
namespace {

TEST(DisjointSets, ManyThreadsFindTheComponentsOfAGraph) {
  constexpr int kNodes = 3000;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    test::Random random(seed);
    std::vector<std::pair<Index, Index>> edges;
    for (int i = 0; i < kNodes; ++i) edges.emplace_back(random.below(kNodes), random.below(kNodes));
    DisjointSets sets(kNodes);
    parallel_each(edges.size(), [&](std::size_t i) { sets.unite(edges[i].first, edges[i].second); });
    std::vector<Index> set;
    const Index count = sets.number(set);

    std::vector<Index> least(kNodes);  // by relaxation, until nothing changes
    for (Index i = 0; i < kNodes; ++i) least[i] = i;
    for (bool changed = true; changed;) {
      changed = false;
      for (const auto& [a, b] : edges)
        if (least[a] != least[b]) least[a] = least[b] = std::min(least[a], least[b]), changed = true;
    }
    std::map<Index, Index> number;  // sets are numbered by their least members
    for (const Index l : least) number.emplace(l, 0);
    Index next = 0;
    for (auto& entry : number) entry.second = next++;
    ASSERT_EQ(count, next);
    for (Index i = 0; i < kNodes; ++i) {
      EXPECT_EQ(sets.find(i), least[i]);
      EXPECT_EQ(set[i], number[least[i]]);
    }
  }
}

TEST(DisjointSets, AreSinglesAtFirst) {
  DisjointSets sets(5);
  std::vector<Index> set;
  EXPECT_EQ(sets.number(set), 5);
  EXPECT_EQ(set, (std::vector<Index>{0, 1, 2, 3, 4}));
}

}  // namespace
}  // namespace filmsticking
