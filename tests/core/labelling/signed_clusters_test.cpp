// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/signed_clusters.h"

#include <gtest/gtest.h>

#include "support/clouds.h"

namespace filmsticking {
namespace {

// Each number has a secret sign; joins that agree with it must never contradict it.
TEST(SignedClusters, SignsAreProductsAlongAnyOrderOfJoins) {
  constexpr Index kCount = 60;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    test::Random random(seed);
    std::vector<int> secret, name;
    for (Index i = 0; i < kCount; ++i) secret.push_back(random.below(2) ? 1 : -1), name.push_back(i);
    SignedClusters clusters(kCount);
    for (int turn = 0; turn < 100; ++turn) {
      const Index i = random.below(kCount), j = random.below(kCount);
      const Index a = clusters.find(i).first, b = clusters.find(j).first;
      if (a != b) {
        clusters.join(a, b, secret[a] * secret[b]);
        const int from = name[j], to = name[i];
        for (int& n : name)
          if (n == from) n = to;
      }
      for (Index k = 0; k < kCount; ++k) {
        const auto [root, sign] = clusters.find(k);
        ASSERT_EQ(sign, secret[k] * secret[root]);
        ASSERT_EQ(name[k] == name[i], root == clusters.find(i).first);
      }
    }
  }
}

}  // namespace
}  // namespace filmsticking
