// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/meeting_tree.h"

#include <gtest/gtest.h>

#include <atomic>

#include "support/surfaces.h"

namespace filmsticking {
namespace {

using Places = std::vector<std::size_t>;

TEST(MeetingTree, FindsFacesThatCrossAndThoseAmongThemselves) {
  Surface sheet = test::square_sheet(40, 1);
  const auto first = static_cast<Index>(sheet.positions.size());
  for (const Vec3& p : {Vec3(0.51, 0.52, -0.5), Vec3(0.52, 0.51, 0.5), Vec3(0.9, 0.9, 0.5),  // crosses
                        Vec3(0.1, 0.1, 0.1), Vec3(0.9, 0.1, 0.1), Vec3(0.5, 0.9, 0.1),       // above
                        Vec3(0.5, 0.5, 0.05), Vec3(0.6, 0.5, 0.3), Vec3(0.5, 0.4, 0.3)})     // crosses that
    sheet.positions.push_back(p), sheet.site.push_back(first);
  MeetingTree tree(sheet);
  const Corners crossing{first, first + 1, first + 2}, above{first + 3, first + 4, first + 5},
      through{first + 6, first + 7, first + 8};
  EXPECT_EQ(tree.meeting({above}, false), Places{});
  EXPECT_EQ(tree.meeting({above, crossing}, false), Places{1});
  EXPECT_EQ(tree.meeting({above, through}, false), Places{1});
  EXPECT_EQ(tree.meeting({above, through}, true), Places{});
  sheet.triangles.push_back(above);  // faces that came later count, too
  EXPECT_EQ(tree.meeting({through}, false), Places{0});
}

TEST(MeetingTree, CommonCornersDoNotCount) {
  const Surface ball = test::ball();
  std::vector<Corners> some(ball.triangles.begin() + 5, ball.triangles.begin() + 40);
  Surface rest = ball;
  rest.triangles.erase(rest.triangles.begin() + 5, rest.triangles.begin() + 40);
  EXPECT_EQ(MeetingTree(rest).meeting(some, false), Places{});
}

TEST(MeetingTree, StopsWhenAsked) {
  const std::atomic<bool> stop{true};
  const Surface ball = test::ball();
  EXPECT_THROW(MeetingTree(ball).meeting({ball.triangles[0]}, false, {&stop}), Cancelled);
}

}  // namespace
}  // namespace filmsticking
