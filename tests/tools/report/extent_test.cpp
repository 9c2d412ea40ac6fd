// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "report/report.h"
#include "support/shapes.h"

namespace filmsticking::mesh_report {
namespace {

using test::box;
using test::joined;
using test::Model;
using test::turned;

Report report(const Model& model) { return report_on(make_surface(model)); }

TEST(MeshExtent, OfABoxWhereverItIsAndHoweverLarge) {
  for (const double away : {0.0, 1e6})
    for (const double unit : {1.0, 1e-90, 1e90}) {
      const Report r = report(box({away * unit, 0, 0}, {(away + 1) * unit, 2 * unit, 3 * unit}));
      EXPECT_NEAR(r.area / (unit * unit), 22, 1e-8);
      ASSERT_TRUE(r.volume);
      EXPECT_NEAR(*r.volume / (unit * unit * unit), 6, 1e-8);
      EXPECT_TRUE(r.outward);
    }
}

TEST(MeshExtent, InsideOutIsNegative) {
  const Report r = report(turned(box()));
  EXPECT_TRUE(r.topology.closed && r.topology.oriented);
  EXPECT_FALSE(r.outward);
  EXPECT_NEAR(r.volume.value(), -1, 1e-12);
}

TEST(MeshExtent, CavitiesAreTakenOff) {
  const Report r = report(joined(box({0, 0, 0}, {3, 3, 3}), turned(box({1, 1, 1}, {2, 2, 2}))));
  EXPECT_NEAR(r.volume.value(), 26, 1e-12);
  EXPECT_NEAR(r.area, 60, 1e-12);
  EXPECT_TRUE(r.outward);
  EXPECT_EQ(r.topology.components, 2);
}

}  // namespace
}  // namespace filmsticking::mesh_report
