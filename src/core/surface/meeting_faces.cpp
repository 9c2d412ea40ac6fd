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

// A face that meets as many others goes at once: all of them would be as many pairs as there are faces,
// squared.
constexpr std::size_t kMostMeetings = 64;
// Faces nearer to each other than this meet, in units of the box that holds the sites: more than rounding,
// but far less than the distance of any two points in single precision, so that near points do not tear a
// surface.
constexpr double kTouch = 1e-12;

// Of every face those that it meets elsewhere than in common corners, which meet it: all, if they are fewer
// than kMostMeetings.
std::vector<std::vector<Index>> find_meetings(const Surface& film) {
  const FaceTree tree(film);
  std::vector<std::vector<Index>> met(film.triangles.size());
  parallel_each(met.size(), [&](std::size_t i) {
    const auto t = static_cast<Index>(i);
    Eigen::AlignedBox3d box;
    for (int k = 0; k < 3; ++k) box.extend(film.corner(t, k));
    box.min().array() -= kTouch, box.max().array() += kTouch;
    tree.all(FaceTree::rounded(box), [&](Index other) {
      if (other != t &&
          !Meeting(film.positions, film.triangles[t], film.triangles[other], kTouch).in_common_corners_only())
        met[i].push_back(other);
      return met[i].size() < kMostMeetings;
    });
  });
  // What is hard to tell may be told differently from the two sides.
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
  std::vector<Index> met;  // places in the list of faces
  std::size_t left = 0;    // how many of these are still there
  double agrees = 0;       // with the faces around its corners: the cosine, in millionths
  std::array<Index, 3> name{};

  // The least is to go first.
  auto rank() const { return std::make_tuple(-static_cast<std::int64_t>(left), agrees, name); }
};

// Those of the faces to be kept that meet another of these.
std::vector<Face> meeting_faces(const Surface& film, const std::vector<std::vector<Index>>& met,
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
  std::vector<Vec3> vertex_normal(film.positions.size(), Vec3::Zero());
  for (Index t = 0; t < static_cast<Index>(film.triangles.size()); ++t)
    for (Index v : film.triangles[t]) vertex_normal[v] += film.area_vector2(t);
  for (Face& face : faces) {
    for (Index other : met[face.t])
      if (place[other] != kNone) face.met.push_back(place[other]);
    face.left = face.met.size();
    const Corners& corners = film.triangles[face.t];
    const Vec3 around = vertex_normal[corners[0]] + vertex_normal[corners[1]] + vertex_normal[corners[2]];
    // The last bits are those of the order in which the faces were added up.
    face.agrees = std::round(1e6 * film.area_vector2(face.t).normalized().dot(around.normalized()));
    for (int k = 0; k < 3; ++k) face.name[k] = film.site[corners[k]];
    std::sort(face.name.begin(), face.name.end());
  }
  return faces;
}

}  // namespace

std::int64_t remove_meeting_faces(Surface& film, const SiteGeometry& geometry, const Cancel& cancel) {
  cancel();
  const std::vector<std::vector<Index>> met = find_meetings(film);
  std::vector<char> keep(met.size());
  for (std::size_t t = 0; t < met.size(); ++t) keep[t] = met[t].size() < kMostMeetings;
  std::vector<Face> faces = meeting_faces(film, met, keep);
  std::set<std::pair<decltype(faces[0].rank()), std::size_t>> worst;
  for (std::size_t i = 0; i < faces.size(); ++i) worst.emplace(faces[i].rank(), i);
  // Ends: a face is taken out once.
  for (; !worst.empty() && faces[worst.begin()->second].left > 0; worst.erase(worst.begin())) {
    const Face& face = faces[worst.begin()->second];
    if (worst.size() % 1024 == 0) cancel();
    keep[face.t] = 0;
    for (const Index i : face.met) {
      const auto other = worst.find({faces[i].rank(), static_cast<std::size_t>(i)});
      if (other == worst.end()) continue;  // it has gone itself
      worst.erase(other);
      --faces[i].left;
      worst.emplace(faces[i].rank(), i);
    }
  }
  const std::int64_t count = std::count(keep.begin(), keep.end(), 0);
  if (count > 0) keep_faces(film, std::move(keep), geometry);
  return count;
}

}  // namespace filmsticking
