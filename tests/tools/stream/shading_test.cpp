// SPDX-License-Identifier: GPL-3.0-or-later
#include "stream/shading.h"

#include <gtest/gtest.h>

namespace filmsticking::stream {
namespace {

TEST(Shades, WhatFacesUpIsLighterThanWhatFacesDown) {
  const Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}, {5, 6, 5}, {6, 5, 5}, {9, 9, 9}},
                  {{0, 1, 2}, {3, 4, 5}}};  // the first up, the second down, the last point in none
  const std::vector<float> light = shades(mesh);
  ASSERT_EQ(light.size(), 7u);
  for (const float shade : light) {
    EXPECT_GE(shade, 0.5f);
    EXPECT_LE(shade, 1.0f);
  }
  EXPECT_GT(light[0], 0.9f);
  EXPECT_LT(light[3], 0.6f);
}

}  // namespace
}  // namespace filmsticking::stream
