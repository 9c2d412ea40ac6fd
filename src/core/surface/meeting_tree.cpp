// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/meeting_tree.h"

#include <algorithm>
#include <array>

#include "geometry/meeting.h"
#include "geometry/quantile.h"

namespace filmsticking {
namespace {

// A piece of a face is so many times as long as the median edge of the surface. The box of a longer one would
// hold much that is not near it.
constexpr double kPiece = 8;

// Appended faces that are compared one by one. More: the tree is made anew.
constexpr std::size_t kNews = 4096;

double median_edge(const Surface& surface) {
  std::vector<double> lengths;
  for (const Corners& t : surface.triangles)
    lengths.push_back((surface.positions[t[0]] - surface.positions[t[1]]).norm());
  return lengths.empty() ? 0 : median(lengths.begin(), lengths.end());
}

using Piece = std::array<Vec3, 3>;

// Where the longest side begins.
int longest_side(const Piece& p) {
  int longest = 0;
  for (int k = 1; k < 3; ++k)
    if ((p[(k + 1) % 3] - p[k]).squaredNorm() > (p[(longest + 1) % 3] - p[longest]).squaredNorm())
      longest = k;
  return longest;
}

}  // namespace

MeetingTree::MeetingTree(const Surface& surface)
    : surface_(surface),
      faces_(surface.triangles.size()),
      piece_(std::max(kPiece * median_edge(surface), 1e-3)),  // of a box of size 1: bounds the pieces
      tree_(surface) {}

std::vector<std::size_t> MeetingTree::meeting(const std::vector<Corners>& faces, bool apart_from_each_other,
                                              const Cancel& cancel) {
  if (surface_.triangles.size() > faces_ + kNews) {
    faces_ = surface_.triangles.size();
    tree_ = FaceTree(surface_);
  }
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    cancel();
    bool meets = meets_surface(faces[i]);
    for (std::size_t k = 0; k < i && !meets && !apart_from_each_other; ++k)
      meets = !Meeting(surface_.positions, faces[i], faces[k], kMeetingMargin).in_common_corners_only();
    if (meets) found.push_back(i);
  }
  return found;
}

bool MeetingTree::meets_surface(const Corners& face) const {
  const auto apart = [&](const Corners& other) {
    return Meeting(surface_.positions, face, other, kMeetingMargin).in_common_corners_only();
  };
  for (std::size_t t = faces_; t < surface_.triangles.size(); ++t)
    if (!apart(surface_.triangles[t])) return true;
  std::vector<Piece> pieces{
      {surface_.positions[face[0]], surface_.positions[face[1]], surface_.positions[face[2]]}};
  while (!pieces.empty()) {  // ends: pieces get shorter
    Piece piece = pieces.back();
    pieces.pop_back();
    const int k = longest_side(piece);
    const Vec3 &a = piece[k], &b = piece[(k + 1) % 3], &c = piece[(k + 2) % 3];
    if ((b - a).norm() > piece_) {
      const Vec3 middle = (a + b) / 2;
      pieces.push_back({a, middle, c}), pieces.push_back({middle, b, c});
      continue;
    }
    Eigen::AlignedBox3d box(a);
    box.extend(b), box.extend(c);
    box.min().array() -= kMeetingMargin, box.max().array() += kMeetingMargin;
    if (!tree_.all(FaceTree::rounded(box), [&](Index t) { return apart(surface_.triangles[t]); }))
      return true;
  }
  return false;
}

}  // namespace filmsticking
