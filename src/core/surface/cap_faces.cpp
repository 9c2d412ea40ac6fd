// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/cap_faces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <utility>

#include "geometry/parallel.h"
#include "geometry/triangle_adjacency.h"

namespace filmsticking {
namespace {

// How far from the edge the corner may be, in units of the box that holds the sites, which is more than float
// coordinates are rounded, and in lengths of the edge: tiny faces are none.
constexpr double kRounding = 1e-7, kFlat = 1e-3;

// The edge of a face, by its first corner's place in it, that the third corner lies on, away from its ends;
// kNone: it is no cap.
Index cap_edge(const Surface& film, const Corners& face) {
  for (int k = 0; k < 3; ++k) {
    const Vec3 &a = film.positions[face[k]], &b = film.positions[face[(k + 1) % 3]],
               &c = film.positions[face[(k + 2) % 3]];
    const double length = (b - a).norm();
    if (!(length > 0)) continue;
    const double margin = std::min(kRounding, kFlat * length), foot = (b - a).dot(c - a) / length;
    if ((b - a).cross(c - a).norm() <= margin * length && foot > margin && foot < length - margin) return k;
  }
  return kNone;
}

bool is_cap(const Surface& film, const Corners& face) { return cap_edge(film, face) != kNone; }

// The caps in an order that no numbering changes.
std::vector<Index> find_cap_faces(const Surface& film) {
  std::vector<char> cap(film.triangles.size());
  parallel_each(cap.size(), [&](std::size_t t) { cap[t] = is_cap(film, film.triangles[t]); });
  std::vector<std::pair<std::array<Index, 3>, Index>> named;
  for (std::size_t t = 0; t < cap.size(); ++t) {
    if (!cap[t]) continue;
    std::array<Index, 3> name;
    for (int k = 0; k < 3; ++k) name[k] = film.site[film.triangles[t][k]];
    std::sort(name.begin(), name.end());
    named.emplace_back(name, static_cast<Index>(t));
  }
  std::sort(named.begin(), named.end());
  std::vector<Index> caps;
  for (const auto& entry : named) caps.push_back(entry.second);
  return caps;
}

class CapRemoval {
 public:
  CapRemoval(Surface& film, const std::vector<Index>& twins)
      : film_(film), twin_(twins), dropped_(film.triangles.size(), 0) {}

  std::int64_t run(const std::vector<Index>& caps) {
    std::int64_t removed = 0;
    for (bool changed = true; changed;) {  // ends: a change leaves a cap less
      changed = false;
      for (const Index t : caps)
        if (remove(t)) ++removed, changed = true;
    }
    std::vector<Corners> kept;
    for (std::size_t t = 0; t < dropped_.size(); ++t)
      if (!dropped_[t]) kept.push_back(film_.triangles[t]);
    film_.triangles.swap(kept);
    return removed;
  }

 private:
  Index origin(Index h) const { return film_.triangles[h / 3][h % 3]; }

  bool remove(Index t) {
    const Index k = dropped_[t] ? kNone : cap_edge(film_, film_.triangles[t]);
    if (k == kNone) return false;
    const Index h = 3 * t + k;
    if (twin_[h] == kNone) {
      // A border that comes to the corner from both sides would part its faces.
      if (!in_a_ring(prev_in_face(h))) return false;
      dropped_[t] = 1;
      for (Index g = 3 * t; g < 3 * t + 3; ++g)
        if (twin_[g] != kNone) twin_[twin_[g]] = kNone, twin_[g] = kNone;
      return true;
    }
    const Index a = origin(h), b = origin(twin_[h]), c = origin(prev_in_face(h)),
                d = origin(prev_in_face(twin_[h]));
    if (c == d || is_cap(film_, {b, a, d}) || is_cap(film_, {d, c, a}) || is_cap(film_, {c, d, b}) ||
        have_edge(film_.triangles, twin_, prev_in_face(h), prev_in_face(twin_[h])))
      return false;
    flip_edge(film_.triangles, twin_, h);
    return true;
  }

  // Do the faces around the origin of a half-edge form a ring?
  bool in_a_ring(Index h) const {
    Index g = h;
    do g = twin_[prev_in_face(g)];
    while (g != kNone && g != h);
    return g == h;
  }

  Surface& film_;
  std::vector<Index> twin_;
  std::vector<char> dropped_;  // of every face
};

}  // namespace

std::int64_t remove_cap_faces(Surface& film, const std::vector<Index>& twins) {
  const std::vector<Index> caps = find_cap_faces(film);
  return caps.empty() ? 0 : CapRemoval(film, twins).run(caps);
}

}  // namespace filmsticking
