// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/quantile.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/clouds.h"

namespace filmsticking {
namespace {

TEST(Quantile, IsTheValueOfThatRankInRisingOrder) {
  test::Random random(1);
  for (std::size_t n = 1; n <= 40; ++n) {
    std::vector<double> values(n);
    for (double& value : values) value = random.uniform(-1, 1);
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(quantile(values.begin(), values.end(), 0), sorted.front());
    EXPECT_EQ(quantile(values.begin(), values.end(), 0.25), sorted[n / 4]);
    EXPECT_EQ(median(values.begin(), values.end()), sorted[n / 2]);
    EXPECT_EQ(quantile(values.begin(), values.end(), 1), sorted.back());
  }
}

}  // namespace
}  // namespace filmsticking
