// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/every_nth.h"

#include <gtest/gtest.h>

namespace filmsticking {
namespace {

TEST(EveryNth, SamplesAtMostSoManyOverTheWholeRange) {
  for (std::size_t most = 1; most <= 12; ++most)
    for (std::size_t count = 1; count <= 60; ++count) {
      const EveryNth sample(count, most);
      ASSERT_GE(sample.size(), 1U);
      EXPECT_LE(sample.size(), most);
      EXPECT_EQ(sample[0], 0U);
      const std::size_t step = sample.size() > 1 ? sample[1] : count;
      EXPECT_LT(sample[sample.size() - 1], count);
      EXPECT_GE(sample[sample.size() - 1] + step, count);
    }
}

TEST(EveryNth, TakesAllOfFew) {
  const EveryNth sample(5, 10);
  EXPECT_EQ(sample.size(), 5U);
  EXPECT_EQ(sample[4], 4U);
}

TEST(EveryNth, IsEmptyForNothing) { EXPECT_EQ(EveryNth(0, 10).size(), 0U); }

}  // namespace
}  // namespace filmsticking
