// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/roughness.h"

#include <gtest/gtest.h>

#include "support/clouds.h"
#include "support/field_setting.h"

namespace filmsticking {
namespace {

using Setting = test::FieldSetting;

TEST(Roughness, IsSmallForASmoothSurfaceAndMoreForRandomLabels) {
  const Setting s(test::sphere(1500, 1));
  test::LabelSetting smooth(s, test::labels_where(s, [](const Point&) { return true; }));
  EXPECT_LT(roughness(smooth.labelling, s.set.perturbed), 0.1);
  test::LabelSetting noise(s, test::random_labels(s.mesh, 1));
  EXPECT_GT(roughness(noise.labelling, s.set.perturbed), 0.3);
}

TEST(Roughness, WithoutASurfaceIsNone) {
  const Setting s(test::sphere(100, 1));
  test::LabelSetting l(s, std::vector<char>(s.mesh.size(), 0));
  EXPECT_EQ(roughness(l.labelling, s.set.perturbed), 0);
}

}  // namespace
}  // namespace filmsticking
