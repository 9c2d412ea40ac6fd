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

// Distance of the corner from the edge, in units of the box around the sites. Below: a sliver. More than the
// rounding of float coordinates.
constexpr double kRounding = 1e-7;
// The same in lengths of the edge, so that a tiny face is no sliver.
constexpr double kFlat = 1e-3;

// The edge that the opposite corner lies on, away from its ends: the place of its first corner in the face.
// kNone: no sliver.
Index cap_edge(const Surface& surface, const Corners& face) {
  for (int k = 0; k < 3; ++k) {
    const Vec3 &a = surface.positions[face[k]], &b = surface.positions[face[(k + 1) % 3]],
               &c = surface.positions[face[(k + 2) % 3]];
    const double length = (b - a).norm();
    if (!(length > 0)) continue;
    const double margin = std::min(kRounding, kFlat * length), foot = (b - a).dot(c - a) / length;
    if ((b - a).cross(c - a).norm() <= margin * length && foot > margin && foot < length - margin) return k;
  }
  return kNone;
}

bool is_cap(const Surface& surface, const Corners& face) { return cap_edge(surface, face) != kNone; }

// The slivers, ordered by their sites: independent of the numbering.
std::vector<Index> find_cap_faces(const Surface& surface) {
  std::vector<char> cap(surface.triangles.size());
  parallel_each(cap.size(), [&](std::size_t t) { cap[t] = is_cap(surface, surface.triangles[t]); });
  std::vector<std::pair<std::array<Index, 3>, Index>> named;
  for (std::size_t t = 0; t < cap.size(); ++t) {
    if (!cap[t]) continue;
    std::array<Index, 3> name;
    for (int k = 0; k < 3; ++k) name[k] = surface.site[surface.triangles[t][k]];
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
  CapRemoval(Surface& surface, const std::vector<Index>& twins)
      : surface_(surface), twin_(twins), dropped_(surface.triangles.size(), 0) {}

  std::int64_t run(const std::vector<Index>& caps) {
    std::int64_t removed = 0;
    for (bool changed = true; changed;) {  // ends: every change leaves one sliver less
      changed = false;
      for (const Index t : caps)
        if (remove(t)) ++removed, changed = true;
    }
    std::vector<Corners> kept;
    for (std::size_t t = 0; t < dropped_.size(); ++t)
      if (!dropped_[t]) kept.push_back(surface_.triangles[t]);
    surface_.triangles.swap(kept);
    return removed;
  }

 private:
  Index origin(Index h) const { return surface_.triangles[h / 3][h % 3]; }

  bool remove(Index t) {
    const Index k = dropped_[t] ? kNone : cap_edge(surface_, surface_.triangles[t]);
    if (k == kNone) return false;
    const Index h = 3 * t + k;
    if (twin_[h] == kNone) {
      // If the corner is at the boundary already, two fans of faces would touch there.
      if (!in_a_ring(prev_in_face(h))) return false;
      dropped_[t] = 1;
      for (Index g = 3 * t; g < 3 * t + 3; ++g)
        if (twin_[g] != kNone) twin_[twin_[g]] = kNone, twin_[g] = kNone;
      return true;
    }
    const Index a = origin(h), b = origin(twin_[h]), c = origin(prev_in_face(h)),
                d = origin(prev_in_face(twin_[h]));
    if (c == d || is_cap(surface_, {b, a, d}) || is_cap(surface_, {d, c, a}) || is_cap(surface_, {c, d, b}) ||
        have_edge(surface_.triangles, twin_, prev_in_face(h), prev_in_face(twin_[h])))
      return false;
    flip_edge(surface_.triangles, twin_, h);
    return true;
  }

  // Do the faces around the origin of a half-edge form a ring?
  bool in_a_ring(Index h) const {
    Index g = h;
    do g = twin_[prev_in_face(g)];
    while (g != kNone && g != h);
    return g == h;
  }

  Surface& surface_;
  std::vector<Index> twin_;
  std::vector<char> dropped_;  // of every face
};

}  // namespace

std::int64_t remove_cap_faces(Surface& surface, const std::vector<Index>& twins) {
  const std::vector<Index> caps = find_cap_faces(surface);
  return caps.empty() ? 0 : CapRemoval(surface, twins).run(caps);
}

}  // namespace filmsticking
