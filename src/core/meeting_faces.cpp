// SPDX-License-Identifier: GPL-3.0-or-later
#include "meeting_faces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "face_tree.h"
#include "meeting.h"
#include "open_surface.h"
#include "parallel.h"

namespace filmsticking {
namespace {

Vec3 area_vector(const GuidingSurface& film, Index t) {
  return (film.corner(t, 1) - film.corner(t, 0)).cross(film.corner(t, 2) - film.corner(t, 0));
}

// Of every face those that it meets elsewhere than in common corners.
std::vector<std::vector<Index>> find_meetings(const GuidingSurface& film) {
  const FaceTree tree(film);
  std::vector<std::vector<Index>> met(film.triangles.size());
  parallel_each(met.size(), [&](std::size_t i) {
    const auto t = static_cast<Index>(i);
    Eigen::AlignedBox3d box;
    for (int k = 0; k < 3; ++k) box.extend(film.corner(t, k));
    tree.all(FaceTree::rounded(box), [&](Index other) {
      if (other != t && !Meeting(film.positions, film.triangles[t], film.triangles[other], kMeetingMargin)
                             .in_common_corners_only())
        met[i].push_back(other);
      return true;
    });
  });
  return met;
}

}  // namespace

std::int64_t remove_meeting_faces(GuidingSurface& film, const SiteGeometry& geometry) {
  std::vector<std::vector<Index>> met = find_meetings(film);
  struct Face {
    Index t;
    double agrees;  // with the faces around its corners: the cosine, in millionths
    std::array<Index, 3> name;
  };
  std::vector<Face> faces;
  for (std::size_t t = 0; t < met.size(); ++t)
    if (!met[t].empty()) faces.push_back({static_cast<Index>(t), 0, {}});
  if (faces.empty()) return 0;

  std::vector<Vec3> vertex_normal(film.positions.size(), Vec3::Zero());
  for (Index t = 0; t < static_cast<Index>(film.triangles.size()); ++t)
    for (Index v : film.triangles[t]) vertex_normal[v] += area_vector(film, t);
  for (Face& face : faces) {
    const Corners& corners = film.triangles[face.t];
    const Vec3 around = vertex_normal[corners[0]] + vertex_normal[corners[1]] + vertex_normal[corners[2]];
    // The last bits are those of the order in which the faces were added up.
    face.agrees = std::round(1e6 * area_vector(film, face.t).normalized().dot(around.normalized()));
    for (int k = 0; k < 3; ++k) face.name[k] = film.site[corners[k]];
    std::sort(face.name.begin(), face.name.end());
  }
  std::vector<char> keep(film.triangles.size(), 1);
  for (;;) {  // ends: a face is taken away once
    const auto worse = [&](const Face& a, const Face& b) {
      return std::make_tuple(met[b.t].size(), a.agrees, a.name) <
             std::make_tuple(met[a.t].size(), b.agrees, b.name);
    };
    const auto worst = std::min_element(faces.begin(), faces.end(), worse);
    if (met[worst->t].empty()) break;
    keep[worst->t] = 0;
    for (Index other : met[worst->t])
      met[other].erase(std::find(met[other].begin(), met[other].end(), worst->t));
    met[worst->t].clear();
  }
  const auto count = static_cast<std::int64_t>(faces.size());
  keep_faces(film, std::move(keep), geometry);
  return count;
}

}  // namespace filmsticking
