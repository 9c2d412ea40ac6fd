// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/components.h"

#include <gtest/gtest.h>

#include <vector>

#include "report/report.h"
#include "support/shapes.h"

namespace filmsticking::mesh_report {
namespace {

using test::box;
using test::joined;
using test::Model;

TEST(Components, HaveTheirOwnAreaAndVolume) {
  Model open = box({5, 0, 0}, {6, 1, 1});
  open.triangles.resize(10);
  const std::vector<Component> parts =
      components(make_surface(joined(joined(box(), open), box({0, 5, 0}, {3, 7, 1}))));
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_DOUBLE_EQ(parts[0].area, 22);
  EXPECT_NEAR(parts[0].volume.value(), 6, 1e-12);
  EXPECT_NEAR(parts[1].volume.value(), 1, 1e-12);
  EXPECT_EQ(parts[2].faces, 10);
  EXPECT_FALSE(parts[2].closed);
  EXPECT_DOUBLE_EQ(parts[2].area, 5);
  EXPECT_FALSE(parts[2].volume);
  EXPECT_TRUE(components(make_surface({})).empty());
}

}  // namespace
}  // namespace filmsticking::mesh_report
