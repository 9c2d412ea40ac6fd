// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/marks.h"

#include <gtest/gtest.h>

namespace filmsticking {
namespace {

TEST(Marks, AreEmptyAtFirstAndAfterAClear) {
  Marks marks(3);
  for (Index i = 0; i < 3; ++i) EXPECT_FALSE(marks.has(i));
  marks.add(1);
  EXPECT_TRUE(marks.has(1));
  EXPECT_FALSE(marks.has(0));
  marks.clear();
  EXPECT_FALSE(marks.has(1));
  marks.add(0);
  EXPECT_TRUE(marks.has(0));
  EXPECT_FALSE(marks.has(1));
}

}  // namespace
}  // namespace filmsticking
