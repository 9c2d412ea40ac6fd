// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/work_limits.h"

#include <gtest/gtest.h>

namespace filmsticking {
namespace {

TEST(WorkLimits, CancelThrowsOnceTheWishIsThere) {
  EXPECT_NO_THROW(Cancel{}());
  std::atomic<bool> wish{false};
  const Cancel cancel{&wish};
  EXPECT_NO_THROW(cancel());
  wish = true;
  EXPECT_THROW(cancel(), Cancelled);
}

TEST(WorkLimits, ATriangulationHasNoLimitByDefault) {
  EXPECT_EQ(TriangulationLimits().tetrahedra, std::numeric_limits<std::int64_t>::max());
  EXPECT_NO_THROW(TriangulationLimits().cancel());
}

}  // namespace
}  // namespace filmsticking
