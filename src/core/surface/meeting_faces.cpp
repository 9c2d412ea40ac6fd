// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/meeting_faces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "geometry/face_tree.h"
#include "geometry/meeting.h"
#include "geometry/parallel.h"
#include "surface/open_surface.h"

namespace filmsticking {
namespace {

// Faces that a face meets. From here on: remove it at once, since all pairs could be the square of the faces.
constexpr std::size_t kMostMeetings = 64;
// Distance of two faces, in units of the box around the sites. Below: they meet. More than rounding, but far
// less than the distance of two points in single precision, so that near points do not tear a surface.
constexpr double kTouch = 1e-12;

// [face]: the faces that it meets elsewhere than in common corners; not all if there are kMostMeetings or
// more. Symmetric.
std::vector<std::vector<Index>> find_meetings(const Surface& surface) {
  const FaceTree tree(surface);
  std::vector<std::vector<Index>> met(surface.triangles.size());
  parallel_each(met.size(), [&](std::size_t i) {
    const auto t = static_cast<Index>(i);
    Eigen::AlignedBox3d box;
    for (int k = 0; k < 3; ++k) box.extend(surface.corner(t, k));
    box.min().array() -= kTouch, box.max().array() += kTouch;
    tree.all(FaceTree::rounded(box), [&](Index other) {
      if (other != t && !Meeting(surface.positions, surface.triangles[t], surface.triangles[other], kTouch)
                             .in_common_corners_only())
        met[i].push_back(other);
      return met[i].size() < kMostMeetings;
    });
  });
  // Rounding may find a meeting from one side only.
  for (std::size_t t = 0; t < met.size(); ++t)
    for (std::size_t i = 0; i < met[t].size(); ++i) {
      const Index other = met[t][i];
      std::vector<Index>& back = met[other];
      if (back.size() < kMostMeetings &&
          std::find(back.begin(), back.end(), static_cast<Index>(t)) == back.end())
        back.push_back(static_cast<Index>(t));
    }
  return met;
}

struct Face {
  Index t = kNone;
  std::vector<Index> met;  // indices into the list of faces
  std::size_t left = 0;    // how many of these are not removed
  double agrees = 0;       // cosine of its normal with those around its corners, in millionths
  std::array<Index, 3> name{};

  // The least is removed first.
  auto rank() const { return std::make_tuple(-static_cast<std::int64_t>(left), agrees, name); }
};

// The faces to keep that meet another face to keep.
std::vector<Face> meeting_faces(const Surface& surface, const std::vector<std::vector<Index>>& met,
                                const std::vector<char>& keep) {
  std::vector<Index> place(met.size(), kNone);
  std::vector<Face> faces;
  for (std::size_t t = 0; t < met.size(); ++t) {
    const auto stays = [&](Index other) { return keep[other] != 0; };
    if (!keep[t] || std::none_of(met[t].begin(), met[t].end(), stays)) continue;
    place[t] = static_cast<Index>(faces.size());
    faces.emplace_back();
    faces.back().t = static_cast<Index>(t);
  }
  if (faces.empty()) return faces;
  std::vector<Vec3> vertex_normal(surface.positions.size(), Vec3::Zero());
  for (Index t = 0; t < static_cast<Index>(surface.triangles.size()); ++t)
    for (Index v : surface.triangles[t]) vertex_normal[v] += surface.area_vector2(t);
  for (Face& face : faces) {
    for (Index other : met[face.t])
      if (place[other] != kNone) face.met.push_back(place[other]);
    face.left = face.met.size();
    const Corners& corners = surface.triangles[face.t];
    const Vec3 around = vertex_normal[corners[0]] + vertex_normal[corners[1]] + vertex_normal[corners[2]];
    // Rounded: the last bits depend on the order of the sum above.
    face.agrees = std::round(1e6 * surface.area_vector2(face.t).normalized().dot(around.normalized()));
    for (int k = 0; k < 3; ++k) face.name[k] = surface.site[corners[k]];
    std::sort(face.name.begin(), face.name.end());
  }
  return faces;
}

}  // namespace

std::int64_t remove_meeting_faces(Surface& surface, const SiteGeometry& geometry, const Cancel& cancel) {
  cancel();
  const std::vector<std::vector<Index>> met = find_meetings(surface);
  std::vector<char> keep(met.size());
  for (std::size_t t = 0; t < met.size(); ++t) keep[t] = met[t].size() < kMostMeetings;
  std::vector<Face> faces = meeting_faces(surface, met, keep);
  std::set<std::pair<decltype(faces[0].rank()), std::size_t>> worst;
  for (std::size_t i = 0; i < faces.size(); ++i) worst.emplace(faces[i].rank(), i);
  // Ends: a face is removed once.
  for (; !worst.empty() && faces[worst.begin()->second].left > 0; worst.erase(worst.begin())) {
    const Face& face = faces[worst.begin()->second];
    if (worst.size() % 1024 == 0) cancel();
    keep[face.t] = 0;
    for (const Index i : face.met) {
      const auto other = worst.find({faces[i].rank(), static_cast<std::size_t>(i)});
      if (other == worst.end()) continue;  // removed before
      worst.erase(other);
      --faces[i].left;
      worst.emplace(faces[i].rank(), i);
    }
  }
  const std::int64_t count = std::count(keep.begin(), keep.end(), 0);
  if (count > 0) keep_faces(surface, std::move(keep), geometry);
  return count;
}

}  // namespace filmsticking
