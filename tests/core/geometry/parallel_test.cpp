// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/parallel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace filmsticking {
namespace {

TEST(Parallel, EveryIndexIsVisitedOnce) {
  for (const std::size_t n : {0U, 1U, 255U, 256U, 257U, 10000U}) {
    std::vector<int> visits(n, 0), chunk_visits(n, 0);
    parallel_each(n, [&](std::size_t i) { ++visits[i]; });
    parallel_chunks(n, 100, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
      EXPECT_EQ(begin, 100 * chunk);
      EXPECT_LE(end - begin, 100U);
      for (std::size_t i = begin; i < end; ++i) ++chunk_visits[i];
    });
    EXPECT_EQ(visits, std::vector<int>(n, 1));
    EXPECT_EQ(chunk_visits, visits);
  }
}

TEST(Parallel, ASumHasTheSameLastBitEveryTime) {
  const auto term = [](std::size_t i) { return std::sin(static_cast<double>(i)) * std::pow(10, i % 17); };
  const double first = parallel_sum(100000, term);
  for (int again = 0; again < 20; ++again) EXPECT_EQ(parallel_sum(100000, term), first);
  EXPECT_EQ(parallel_sum(0, term), 0);
  EXPECT_EQ(parallel_sum(100000, [](std::size_t) { return 1; }), 100000);
}

}  // namespace
}  // namespace filmsticking
