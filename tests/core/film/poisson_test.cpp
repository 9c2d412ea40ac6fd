// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/poisson.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/clouds.h"
#include "support/field_setting.h"

namespace filmsticking {
namespace {

using Setting = test::FieldSetting;

TEST(Poisson, SeparatesInsideFromOutside) {
  const Setting s(test::sphere(2000, 8));
  std::vector<Vec3> normals;
  for (const Vec3& p : s.set.perturbed) normals.push_back(p.normalized());
  const auto belief = poisson_belief(s.mesh, s.set.perturbed, normals);
  ASSERT_EQ(belief.size(), s.mesh.size());
  int right = 0, all = 0;
  for (std::size_t t = 0; t < s.mesh.size(); ++t) {
    if (s.mesh.tets.infinite(static_cast<Index>(t)) || std::abs(s.centre(t).norm() - 0.5) < 0.03) continue;
    ++all;
    right += (belief[t] > 0) == (s.centre(t).norm() < 0.5);
  }
  EXPECT_GT(right, all * 99 / 100);
  EXPECT_TRUE(poisson_belief(s.mesh, s.set.perturbed, std::vector<Vec3>(s.set.size(), Vec3::Zero())).empty());
}

}  // namespace
}  // namespace filmsticking
