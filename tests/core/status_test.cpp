// SPDX-License-Identifier: GPL-3.0-or-later
#include "filmsticking/status.h"

#include <gtest/gtest.h>

#include <cctype>
#include <set>
#include <string>

namespace filmsticking {
namespace {

TEST(Status, EveryOneHasItsOwnSentence) {
  std::set<std::string> sentences;
  int count = 0;
  for (int i = 0; i <= static_cast<int>(Status::InternalError); ++i, ++count) {
    const std::string sentence = describe(static_cast<Status>(i));
    sentences.insert(sentence);
    ASSERT_GT(sentence.size(), 10U);
    EXPECT_TRUE(std::islower(static_cast<unsigned char>(sentence.front()))) << sentence;
    EXPECT_NE(sentence.back(), '.') << sentence;
  }
  EXPECT_EQ(static_cast<int>(sentences.size()), count);
  EXPECT_EQ(sentences.count("unknown status"), 0U);
}

TEST(Status, ANumberThatIsNoneHasOneToo) {
  EXPECT_STREQ(describe(static_cast<Status>(99)), "unknown status");
}

}  // namespace
}  // namespace filmsticking
