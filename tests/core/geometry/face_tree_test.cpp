// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/face_tree.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/surfaces.h"

namespace filmsticking {
namespace {

Eigen::AlignedBox3d box_of(const Surface& surface, Index t) {
  Eigen::AlignedBox3d box;
  for (int k = 0; k < 3; ++k) box.extend(surface.corner(t, k));
  return box;
}

std::vector<Index> found(const FaceTree& tree, const Eigen::AlignedBox3d& box) {
  std::vector<Index> faces;
  EXPECT_TRUE(tree.all(FaceTree::rounded(box), [&](Index t) { return faces.push_back(t), true; }));
  return faces;
}

TEST(FaceTree, FindsEveryFaceThatMeetsABoxInRisingOrder) {
  const Surface ball = test::ball();
  const FaceTree tree(ball);
  std::size_t seen = 0;
  for (Index t = 0; t < static_cast<Index>(ball.triangles.size()); t += 17) {
    const Eigen::AlignedBox3d box = box_of(ball, t);
    const std::vector<Index> faces = found(tree, box);
    EXPECT_TRUE(std::is_sorted(faces.begin(), faces.end()));
    for (Index u = 0; u < static_cast<Index>(ball.triangles.size()); ++u)
      if (box_of(ball, u).intersects(box)) {
        EXPECT_TRUE(std::binary_search(faces.begin(), faces.end(), u));
      }
    seen += faces.size();
  }
  EXPECT_LT(seen * 2, ball.triangles.size() * (ball.triangles.size() / 17 + 1));  // not simply all faces
}

TEST(FaceTree, FindsAFaceWhereItHasMoved) {
  const Surface ball = test::ball();
  FaceTree tree(ball);
  const Eigen::AlignedBox3d far(Vec3(40, 40, 40), Vec3(41, 41, 41));
  EXPECT_TRUE(found(tree, far).empty());
  tree.add(9, FaceTree::rounded(far));
  const std::vector<Index> faces = found(tree, far);
  EXPECT_TRUE(std::binary_search(faces.begin(), faces.end(), 9));
}

TEST(FaceTree, StopsWhereAVisitSaysSo) {
  const Surface ball = test::ball();
  const FaceTree tree(ball);
  int visits = 0;
  EXPECT_FALSE(
      tree.all(FaceTree::rounded({Vec3(-9, -9, -9), Vec3(9, 9, 9)}), [&](Index) { return ++visits < 3; }));
  EXPECT_EQ(visits, 3);
}

TEST(FaceTree, RoundsOutward) {
  const Eigen::AlignedBox3d exact(Vec3(0.1, -0.1, 1e-50), Vec3(0.3, 0.7, 1e10 + 1));
  EXPECT_TRUE(FaceTree::rounded(exact).cast<double>().contains(exact));
}

TEST(FaceTree, OfNoFaceFindsNone) {
  EXPECT_TRUE(found(FaceTree(Surface()), {Vec3(0, 0, 0), Vec3(1, 1, 1)}).empty());
}

}  // namespace
}  // namespace filmsticking
