// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/unset_vector.h"

#include <gtest/gtest.h>

#include <string>

namespace filmsticking {
namespace {

TEST(UnsetVector, KeepsValuesThatAreGiven) {
  UnsetVector<int> numbers(3, 7);
  numbers.push_back(8);
  numbers.resize(6, 9);
  EXPECT_EQ(numbers, (UnsetVector<int>{7, 7, 7, 8, 9, 9}));
}

TEST(UnsetVector, DoesNotWriteToNewElements) {
  UnsetVector<int> numbers(4, 5);
  numbers.resize(0);
  numbers.resize(4);  // in the same memory
  EXPECT_EQ(numbers, (UnsetVector<int>(4, 5)));
}

TEST(UnsetVector, ConstructsClasses) {
  const UnsetVector<std::string> names(3);
  for (const std::string& name : names) EXPECT_EQ(name, "");
}

}  // namespace
}  // namespace filmsticking
