// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/lids.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>

#include "geometry/triangle_adjacency.h"
#include "surface/least_triangulation.h"
#include "surface/meeting_tree.h"
#include "surface/plane_triangulation.h"

namespace filmsticking {
namespace {

// Corners of a rim. More: in its plane first, as least_triangulation() takes the cube of their number.
constexpr std::size_t kLong = 300;
// More: in its plane only.
constexpr std::size_t kTooLong = 2000;
// Price of a face's longest edge, squared, beside its area: among lids of one area well-shaped faces win.
constexpr double kShape = 0.1;

// Tries for a triangulation that meets no other faces, and the most steps of all together.
constexpr double kTries = 40, kWork = 6e9;
// Volume of a component over its area to the power of 3/2. Less: the lid lies on its faces.
constexpr double kNoVolume = 1e-9;

class Lids {
 public:
  Lids(Surface& surface, const std::vector<Index>& twins, const Cancel& cancel)
      : surface_(surface),
        twins_(twins),
        cancel_(cancel),
        tree_(surface),
        border_(surface.positions.size(), kNone) {
    for (Index h = 0; h < static_cast<Index>(twins.size()); ++h)
      if (twins[h] == kNone) border_[origin(next_in_face(h))] = h;
  }

  bool close(const Rim& rim) {
    if (is_single_face(rim)) return false;
    joined_.clear();
    for (const Index v : rim) joined_.push_back(neighbours(v));
    best_ = {};
    const bool done =
        rim.size() <= kLong ? try_least(rim) || try_plane(rim) : try_plane(rim) || try_least(rim);
    if (best_.faces.empty() || (!done && is_flat_with(rim, best_.faces))) return false;
    surface_.triangles.insert(surface_.triangles.end(), best_.faces.begin(), best_.faces.end());
    return true;
  }

 private:
  Index origin(Index h) const { return surface_.triangles[h / 3][h % 3]; }

  // Its lid would be the same face, turned over.
  bool is_single_face(const Rim& rim) const {
    return rim.size() == 3 && std::all_of(rim.begin(), rim.end(),
                                          [&](Index v) { return border_[v] / 3 == border_[rim[0]] / 3; });
  }

  // Sorted; the faces of a boundary vertex form a fan.
  std::vector<Index> neighbours(Index v) const {
    std::vector<Index> all{origin(border_[v])};
    for (Index g = next_in_face(border_[v]);; g = next_in_face(twins_[g])) {
      all.push_back(origin(next_in_face(g)));
      if (twins_[g] == kNone) break;
    }
    std::sort(all.begin(), all.end());
    return all;
  }

  // Corners of the rim, by their places in it.
  bool is_joined(const Rim& rim, std::size_t i, std::size_t k) const {
    return std::binary_search(joined_[i].begin(), joined_[i].end(), rim[k]);
  }

  struct Lid {
    std::vector<Corners> faces;
    std::size_t meeting = std::numeric_limits<std::size_t>::max();  // faces that meet others
  };

  // Keeps the lid that meets least. True: it meets nothing.
  bool try_plane(const Rim& rim) {
    const std::vector<Corners> faces = in_plane(rim);
    if (!faces.empty()) consider(faces, tree_.meeting(faces, true, cancel_).size());
    return best_.meeting == 0;
  }
  void consider(const std::vector<Corners>& faces, std::size_t meeting) {
    if (meeting < best_.meeting) best_ = {faces, meeting};
  }

  // Faces that meet others are forbidden, and the next best triangulation is tried.
  bool try_least(const Rim& rim) {
    if (rim.size() > kTooLong) return false;
    const double n = static_cast<double>(rim.size());
    const int rounds = static_cast<int>(std::clamp(kWork / (n * n * n), 1.0, kTries));
    std::set<Corners> forbidden;
    for (int round = 0; round < rounds && best_.meeting > 0; ++round) {
      const std::vector<Corners> faces = least(rim, forbidden);
      if (faces.empty()) break;
      const std::vector<std::size_t> meeting = tree_.meeting(faces, false, cancel_);
      consider(faces, meeting.size());
      for (const std::size_t i : meeting) forbidden.insert(faces[i]);
    }
    return best_.meeting == 0;
  }

  // Does the component of a rim enclose nothing with this lid? Another rim may still let it be open.
  bool is_flat_with(const Rim& rim, const std::vector<Corners>& lid) const {
    std::vector<Index> open{border_[rim[0]] / 3};
    std::set<Index> known(open.begin(), open.end());
    std::vector<Corners> faces = lid;
    while (!open.empty()) {  // ends: every face is added once
      const Index t = open.back();
      open.pop_back();
      faces.push_back(surface_.triangles[t]);
      for (int k = 0; k < 3; ++k)
        if (const Index g = twins_[3 * t + k]; g != kNone && known.insert(g / 3).second)
          open.push_back(g / 3);
    }
    const Vec3 origin = surface_.positions[rim[0]];
    double volume = 0, area = 0;
    for (const Corners& f : faces) {
      const Vec3 a = surface_.positions[f[0]] - origin, b = surface_.positions[f[1]] - origin,
                 c = surface_.positions[f[2]] - origin;
      volume += a.dot(b.cross(c)) / 6;
      area += (b - a).cross(c - a).norm() / 2;
    }
    return std::abs(volume) <= kNoVolume * area * std::sqrt(area);
  }

  std::vector<Corners> least(const Rim& rim, const std::set<Corners>& forbidden) const {
    const auto cost = [&](std::size_t i, std::size_t j, std::size_t k) {
      if (!forbidden.empty() && forbidden.count({rim[i], rim[j], rim[k]}) > 0)
        return std::numeric_limits<double>::infinity();
      const Vec3 &a = surface_.positions[rim[i]], &b = surface_.positions[rim[j]],
                 &c = surface_.positions[rim[k]];
      const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
      return (b - a).cross(c - a).norm() + kShape * longest;
    };
    return least_triangulation(
        rim, [&](std::size_t i, std::size_t k) { return !is_joined(rim, i, k); }, cost, cancel_);
  }

  std::vector<Corners> in_plane(const Rim& rim) const {
    cancel_();
    std::vector<Vec3> corners;
    for (const Index v : rim) corners.push_back(surface_.positions[v]);
    std::vector<Corners> faces = plane_triangulation(corners);
    const std::size_t n = rim.size();
    for (Corners& t : faces) {
      for (int k = 0; k < 3; ++k) {
        const auto i = static_cast<std::size_t>(t[k]), j = static_cast<std::size_t>(t[(k + 1) % 3]);
        const bool chord = (i + 1) % n != j && (j + 1) % n != i;
        if (chord && is_joined(rim, i, j)) return {};
      }
      for (Index& v : t) v = rim[static_cast<std::size_t>(v)];
    }
    return faces;
  }

  Surface& surface_;
  const std::vector<Index>& twins_;
  const Cancel& cancel_;
  MeetingTree tree_;
  std::vector<Index> border_;  // [vertex]: the half-edge without a twin that ends there
  Lid best_;
  std::vector<std::vector<Index>> joined_;  // [corner of the rim]: its neighbours
};

}  // namespace

std::vector<Opening> close_rims(Surface& surface, const std::vector<Index>& twins, double most,
                                const Cancel& cancel) {
  std::vector<Opening> openings;
  for (Rim& rim : find_rims(rim_edges(surface.triangles, twins))) openings.push_back({std::move(rim)});
  if (!(most > 0) || openings.empty()) return openings;
  Lids lids(surface, twins, cancel);
  for (Opening& opening : openings) {
    cancel();
    std::vector<Vec3> corners;
    for (const Index v : opening.rim) corners.push_back(surface.positions[v]);
    opening.closed = measure_rim(corners).diameter <= most && lids.close(opening.rim);
  }
  return openings;
}

}  // namespace filmsticking
