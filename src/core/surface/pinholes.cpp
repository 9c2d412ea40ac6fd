// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/pinholes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "geometry/triangle_adjacency.h"
#include "surface/least_triangulation.h"
#include "surface/meeting_tree.h"
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
      : surface_(surface), twin_(twins), geometry_(geometry), viewpoint_(viewpoint) {}

  std::int64_t run() {
    const std::vector<Line> lines = find_lines();
    if (lines.empty()) return 0;
    MeetingTree tree(surface_);
    std::int64_t filled = 0;
    for (const Line& line : lines) {
      const std::vector<Corners> filling = triangulation(line);
      if (filling.empty() || !tree.meeting(filling, false).empty()) continue;
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

  // Of least area. Empty if there is none.
  std::vector<Corners> triangulation(const Line& line) const {
    Vec3 around = Vec3::Zero();
    for (Index v : line) around += area(surface_.triangles[border_[v] / 3]);
    std::vector<std::vector<Index>> joined;
    for (Index v : line) joined.push_back(neighbours(v));
    const auto cost = [&](std::size_t i, std::size_t j, std::size_t k) {
      const Corners face{line[i], line[j], line[k]};
      const Vec3 own = area(face);
      const bool good = own.dot(around) >= kAgrees * own.norm() * around.norm() &&
                        shows_front(own, line[j]) && is_narrow(surface_, face, geometry_);
      return good ? own.norm() : std::numeric_limits<double>::infinity();
    };
    return least_triangulation(
        line,
        [&](std::size_t i, std::size_t k) {
          return std::find(joined[i].begin(), joined[i].end(), line[k]) == joined[i].end();
        },
        cost, [] {});
  }

  bool shows_front(const Vec3& area, Index corner) const {
    return viewpoint_ == nullptr || area.dot(*viewpoint_ - surface_.positions[corner]) > 0;
  }

  Surface& surface_;
  const std::vector<Index>& twin_;
  const SiteGeometry& geometry_;
  const Vec3* viewpoint_;
  std::vector<Index> border_;  // [vertex]: the half-edge without a twin that ends there
};

}  // namespace

std::int64_t fill_pinholes(Surface& surface, const std::vector<Index>& twins, const SiteGeometry& geometry,
                           const Vec3* viewpoint) {
  return Pinholes(surface, twins, geometry, viewpoint).run();
}

}  // namespace filmsticking
