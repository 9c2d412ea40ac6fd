// SPDX-License-Identifier: GPL-3.0-or-later
#include "evidence/signed_field.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "support/clouds.h"
#include "support/field_setting.h"

namespace filmsticking {
namespace {

using Setting = test::FieldSetting;

TEST(SignedField, KnowsNestedSpheresByParity) {
  auto points = test::sphere(6000, 5);
  for (const Point& p : test::sphere(1500, 6, {0, 0, 0}, 0.5)) points.push_back(p);
  const Setting s(points);
  const auto field = signed_field(s.mesh, s.evidence, s.geometry, std::vector<double>(s.mesh.size(), 0));
  int right = 0, all = 0;
  for (std::size_t t = 0; t < s.mesh.size(); ++t) {
    if (s.mesh.tets.infinite(static_cast<Index>(t))) continue;
    const double r = s.centre(t).norm() * 2;
    if (std::abs(r - 1) < 0.1 || std::abs(r - 0.5) < 0.1) continue;
    ++all;
    right += (field[t] > 0) == (r < 1 && r > 0.5);
  }
  EXPECT_GT(right, all * 99 / 100);
}

TEST(SignedField, OfOneSphereIsPositiveInsideWhateverTheGuess) {
  const Setting s(test::sphere(3000, 7));
  for (const double guess : {-1.0, 0.0, 1.0}) {
    const auto field =
        signed_field(s.mesh, s.evidence, s.geometry, std::vector<double>(s.mesh.size(), guess));
    int right = 0, all = 0;
    for (std::size_t t = 0; t < s.mesh.size(); ++t) {
      if (s.mesh.tets.infinite(static_cast<Index>(t))) {
        EXPECT_EQ(field[t], -1);
        continue;
      }
      if (std::abs(s.centre(t).norm() - 0.5) < 0.05) continue;
      ++all;
      right += (field[t] > 0) == (s.centre(t).norm() < 0.5);
    }
    EXPECT_GT(right, all * 99 / 100) << guess;
  }
}

TEST(SignedField, LeavesASolutionAlone) {
  const Setting s(test::torus(2000, 3));
  const auto once = signed_field(s.mesh, s.evidence, s.geometry, std::vector<double>(s.mesh.size(), 0));
  const auto twice = signed_field(s.mesh, s.evidence, s.geometry, once);
  double most = 0;
  for (std::size_t t = 0; t < once.size(); ++t) most = std::max(most, std::abs(once[t] - twice[t]));
  EXPECT_LT(most, 0.01);
}

TEST(SignedField, ACancelledSolveThrows) {
  const Setting s(test::sphere(500, 1));
  const std::atomic<bool> wish{true};
  EXPECT_THROW(
      signed_field(s.mesh, s.evidence, s.geometry, std::vector<double>(s.mesh.size(), 0), {}, {&wish}),
      Cancelled);
}

}  // namespace
}  // namespace filmsticking
