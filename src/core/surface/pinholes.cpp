// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/pinholes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/face_tree.h"
#include "geometry/meeting.h"
#include "geometry/triangle_adjacency.h"
#include "surface/open_surface.h"

namespace filmsticking {
namespace {

// Edges of a boundary loop. More: no pinhole.
constexpr std::size_t kMostEdges = 12;
// Cosine between a new face and the faces around the hole. Less: do not fill.
constexpr double kAgrees = 0.3;

using Line = std::vector<Index>;  // the vertices of a loop, in the direction of the faces that would fill it

class Pinholes {
 public:
  Pinholes(Surface& surface, const std::vector<Index>& twins, const SiteGeometry& geometry,
           const Vec3* viewpoint)
      : surface_(surface),
        twin_(twins),
        geometry_(geometry),
        viewpoint_(viewpoint),
        faces_(surface.triangles.size()) {}

  std::int64_t run() {
    const std::vector<Line> lines = find_lines();
    if (lines.empty()) return 0;
    const FaceTree tree(surface_);
    std::int64_t filled = 0;
    for (const Line& line : lines) {
      const std::vector<Corners> filling = triangulation(line);
      if (filling.empty() || meets(tree, filling)) continue;
      surface_.triangles.insert(surface_.triangles.end(), filling.begin(), filling.end());
      ++filled;
    }
    return filled;
  }

 private:
  Index origin(Index h) const { return surface_.triangles[h / 3][h % 3]; }
  Vec3 area(const Corners& t) const {
    return (surface_.positions[t[1]] - surface_.positions[t[0]])
        .cross(surface_.positions[t[2]] - surface_.positions[t[0]]);
  }

  // Each loop starts at its least site; the loops are in the order of these.
  std::vector<Line> find_lines() {
    border_.assign(surface_.positions.size(), kNone);
    for (Index h = 0; h < static_cast<Index>(twin_.size()); ++h)
      if (twin_[h] == kNone)
        border_[origin(next_in_face(h))] = h;  // a loop runs against the faces of its edges
    std::vector<char> met(surface_.positions.size(), 0);
    std::vector<Line> lines;
    for (Index v = 0; v < static_cast<Index>(border_.size()); ++v) {
      Line line;
      for (Index u = v; border_[u] != kNone && !met[u]; u = origin(border_[u])) met[u] = 1, line.push_back(u);
      if (line.size() < 3 || line.size() > kMostEdges) continue;
      std::rotate(line.begin(),
                  std::min_element(line.begin(), line.end(),
                                   [&](Index a, Index b) { return surface_.site[a] < surface_.site[b]; }),
                  line.end());
      lines.push_back(std::move(line));
    }
    std::sort(lines.begin(), lines.end(),
              [&](const Line& a, const Line& b) { return surface_.site[a[0]] < surface_.site[b[0]]; });
    return lines;
  }

  // The neighbours of a boundary vertex, whose faces form a fan.
  std::vector<Index> neighbours(Index v) const {
    std::vector<Index> all{origin(border_[v])};
    for (Index g = next_in_face(border_[v]);; g = next_in_face(twin_[g])) {
      all.push_back(origin(next_in_face(g)));
      if (twin_[g] == kNone) return all;
    }
  }

  // Of least area, by dynamic programming over parts of the loop. Empty if there is none.
  std::vector<Corners> triangulation(const Line& line) const {
    const std::size_t n = line.size();
    Vec3 around = Vec3::Zero();
    for (Index v : line) around += area(surface_.triangles[border_[v] / 3]);
    constexpr double kNever = std::numeric_limits<double>::infinity();
    std::array<std::array<double, kMostEdges>, kMostEdges> cost{};
    std::array<std::array<std::size_t, kMostEdges>, kMostEdges> middle{};
    for (std::size_t i = 0; i + 2 < n; ++i) {
      const std::vector<Index> joined = neighbours(line[i]);
      for (std::size_t k = i + 2; k < n; ++k)
        if ((i > 0 || k + 1 < n) && std::find(joined.begin(), joined.end(), line[k]) != joined.end())
          cost[i][k] = kNever;
    }
    for (std::size_t length = 2; length < n; ++length)
      for (std::size_t i = 0; i + length < n; ++i) {
        const std::size_t k = i + length;
        double least = kNever;
        for (std::size_t j = i + 1; j < k && cost[i][k] < kNever; ++j) {
          const Corners face{line[i], line[j], line[k]};
          const Vec3 own = area(face);
          const bool good = own.dot(around) >= kAgrees * own.norm() * around.norm() &&
                            shows_front(own, line[j]) && is_narrow(surface_, face, geometry_);
          const double with = good ? cost[i][j] + cost[j][k] + own.norm() : kNever;
          if (with < least) least = with, middle[i][k] = j;
        }
        cost[i][k] = least;
      }
    if (!(cost[0][n - 1] < kNever)) return {};
    std::vector<Corners> faces;
    std::vector<std::array<std::size_t, 2>> open{{0, n - 1}};
    while (!open.empty()) {  // ends: both parts are shorter
      const auto [i, k] = open.back();
      open.pop_back();
      if (k < i + 2) continue;
      const std::size_t j = middle[i][k];
      faces.push_back({line[i], line[j], line[k]});
      open.push_back({i, j}), open.push_back({j, k});
    }
    return faces;
  }

  bool shows_front(const Vec3& area, Index corner) const {
    return viewpoint_ == nullptr || area.dot(*viewpoint_ - surface_.positions[corner]) > 0;
  }

  // Does a filling meet the surface, other fillings, or itself?
  bool meets(const FaceTree& tree, const std::vector<Corners>& filling) const {
    for (std::size_t i = 0; i < filling.size(); ++i) {
      const auto apart = [&](const Corners& other) {
        return Meeting(surface_.positions, filling[i], other, kMeetingMargin).in_common_corners_only();
      };
      Eigen::AlignedBox3d box;
      for (Index v : filling[i]) box.extend(surface_.positions[v]);
      box.min().array() -= kMeetingMargin, box.max().array() += kMeetingMargin;
      if (!tree.all(FaceTree::rounded(box), [&](Index t) { return apart(surface_.triangles[t]); }))
        return true;
      for (std::size_t t = faces_; t < surface_.triangles.size(); ++t)
        if (!apart(surface_.triangles[t])) return true;
      for (std::size_t k = 0; k < i; ++k)
        if (!apart(filling[k])) return true;
    }
    return false;
  }

  Surface& surface_;
  const std::vector<Index>& twin_;
  const SiteGeometry& geometry_;
  const Vec3* viewpoint_;
  std::size_t faces_;          // number of faces before any filling
  std::vector<Index> border_;  // [vertex]: the half-edge without a twin that ends there
};

}  // namespace

std::int64_t fill_pinholes(Surface& surface, const std::vector<Index>& twins, const SiteGeometry& geometry,
                           const Vec3* viewpoint) {
  return Pinholes(surface, twins, geometry, viewpoint).run();
}

}  // namespace filmsticking
