// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/dual_complex.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/parallel.h"

namespace filmsticking {
namespace {

// What is across a polygon's edge: a half-edge of the dual, as chunk << 32 | its number in the chunk, or one
// side of a crossing, as a negative number.
using Port = std::int64_t;
Port side_port(std::int64_t side) { return -1 - side; }
bool is_side(Port p) { return p < 0; }
std::int64_t side_of(Port p) { return -1 - p; }

// Makes the dual of a chunk of faces.
class FaceFiller {
 public:
  FaceFiller(const Surface& surface, const RestrictedPowerDiagram& restricted, const PowerDiagram& diagram,
             std::size_t chunk, std::vector<Port>& inside)
      : surface_(surface),
        restricted_(restricted),
        diagram_(diagram),
        chunk_(static_cast<Port>(chunk) << 32),
        inside_(inside) {}

  std::vector<Index> site;   // per half-edge of this chunk
  std::vector<Port> across;  // per half-edge of this chunk
  std::vector<Vec3> point;   // per triangle of this chunk

  void fill(Index face) {
    border_.clear();
    for (Index k = 0; k < 3; ++k) append_edge(3 * face + k);
    if (border_.empty()) return;
    prepare_plane(face);
    // A cell meets a face in one convex region. So where a site occurs twice along the border, the dual is
    // pinched: divide the polygon into polygons of distinct sites.
    polygon_.clear();
    for (const Corner& corner : border_) {
      const auto twin = std::find_if(polygon_.begin(), polygon_.end(),
                                     [&](const Corner& c) { return c.site == corner.site; });
      if (twin != polygon_.end()) {
        stack_.emplace_back(twin, polygon_.end());
        polygon_.erase(twin, polygon_.end());
      }
      polygon_.push_back(corner);
    }
    stack_.push_back(polygon_);
    used_.clear();
    for (const Corner& corner : border_) used_.push_back(corner.site);
    std::sort(used_.begin(), used_.end());
    // Ends: a polygon is divided into smaller ones, or gains a site that is new to the face.
    while (!stack_.empty()) {
      std::vector<Corner> top = std::move(stack_.back());
      stack_.pop_back();
      triangulate(std::move(top));
    }
  }

 private:
  struct Corner {
    Index site;
    Port port;  // across the polygon edge from this corner to the next
  };

  void append_edge(Index h) {
    const Index e = restricted_.edge[h], n = restricted_.offset[e + 1] - restricted_.offset[e];
    const bool forward = restricted_.forward[h] != 0;
    for (Index i = 0; i + 1 < n; ++i) {
      const Index at = forward ? i : n - 2 - i;
      const Index from = restricted_.cell[restricted_.offset[e] + (forward ? at : at + 1)];
      border_.push_back({from, side_port(2 * std::int64_t(restricted_.crossing(e, at)) + (forward ? 0 : 1))});
    }
  }

  void prepare_plane(Index face) {
    origin_ = surface_.corner(face, 0);
    const Vec3 e1 = surface_.corner(face, 1) - origin_, e2 = surface_.corner(face, 2) - origin_;
    Vec3 normal = e1.cross(e2);
    x_axis_ = e1.squaredNorm() > e2.squaredNorm() ? e1 : e2;
    if (x_axis_.squaredNorm() > 0) x_axis_.normalize();
    y_axis_ = normal.cross(x_axis_);
    if (y_axis_.squaredNorm() > 0) y_axis_.normalize();
  }

  // A site's power on the face's plane: |x-p|^2 - w = |x|^2 - 2 x.flat + height for x in the plane.
  struct Projected {
    Eigen::Vector2d flat;
    double height;
  };
  Projected project(Index s) const {
    const Vec3 p = diagram_.position[s] - origin_;
    return {{p.dot(x_axis_), p.dot(y_axis_)},
            p.squaredNorm() - (diagram_.weight.empty() ? 0 : diagram_.weight[s])};
  }

  // The line on the face's plane that contains the arc between two cells.
  struct Arc {
    Projected a;
    Eigen::Vector2d start, direction;
    bool valid;
  };
  Arc arc(Index sa, Index sb) const {
    Arc r{project(sa), {}, {}, true};
    const Projected b = project(sb);
    const Eigen::Vector2d ab = b.flat - r.a.flat;
    const double l2 = ab.squaredNorm();
    r.valid = l2 > 0;
    if (!r.valid) return r;
    r.start = ab * ((b.height - r.a.height) / (2 * l2));
    r.direction = {-ab.y(), ab.x()};
    return r;
  }
  // Where along the arc the cell of s ends it; infinity if s is not ahead.
  double end_of_arc(const Arc& r, Index s) const {
    const Projected c = project(s);
    const Eigen::Vector2d ac = c.flat - r.a.flat;
    const double ahead = r.direction.dot(ac);
    if (!(ahead > 0)) return std::numeric_limits<double>::infinity();
    return (c.height - r.a.height - 2 * r.start.dot(ac)) / (2 * ahead);
  }

  // A point of an arc, in space. The face's first corner if rounding left no arc.
  Vec3 point_at(const Arc& r, double s) const {
    if (!r.valid || !std::isfinite(s)) return origin_;
    const Eigen::Vector2d x = r.start + s * r.direction;
    return origin_ + x.x() * x_axis_ + x.y() * y_axis_;
  }

  Index add_triangle(Index a, Index b, Index c, const Vec3& where) {
    const Index h = static_cast<Index>(site.size());
    site.insert(site.end(), {a, b, c});
    across.insert(across.end(), 3, 0);
    point.push_back(where);
    return h;
  }
  Port port_of(Index h) const { return chunk_ | h; }
  void set(Port p, Port other) {
    if (is_side(p))
      inside_[side_of(p)] = other;
    else
      across[p & 0xffffffff] = other;
  }
  void connect(Port p, Port q) { set(p, q), set(q, p); }

  // Gift wrapping: the arc between the polygon's first two cells ends at the first cell ahead.
  void triangulate(std::vector<Corner> p) {
    if (p.size() == 2) return connect(p[0].port, p[1].port);
    const Index a = p[0].site, b = p[1].site;
    const Arc r = arc(a, b);
    std::size_t apex = 2;
    double first = std::numeric_limits<double>::infinity();
    Index inner = kNone;
    if (r.valid) {
      for (std::size_t k = 2; k < p.size(); ++k) {
        const double s = end_of_arc(r, p[k].site);
        if (s < first) first = s, apex = k;
      }
      for (Index k = diagram_.offset[a]; k < diagram_.offset[a + 1]; ++k) {
        const Index c = diagram_.neighbour[k];
        const double s = end_of_arc(r, c);
        if (s < first && !std::binary_search(used_.begin(), used_.end(), c)) first = s, inner = c;
      }
    }
    if (inner != kNone) {
      // The apex is a cell inside the face. Ends: each is used once.
      used_.insert(std::lower_bound(used_.begin(), used_.end(), inner), inner);
      const Index h = add_triangle(a, b, inner, point_at(r, first));
      connect(port_of(h), p[0].port);
      std::vector<Corner> rest;
      rest.reserve(p.size() + 1);
      rest.push_back({a, port_of(h + 2)});
      rest.push_back({inner, port_of(h + 1)});
      rest.insert(rest.end(), p.begin() + 1, p.end());
      stack_.push_back(std::move(rest));
      return;
    }
    const Index h = add_triangle(a, b, p[apex].site, point_at(r, first));
    connect(port_of(h), p[0].port);
    std::vector<Corner> left(p.begin() + 1, p.begin() + static_cast<std::ptrdiff_t>(apex) + 1);
    left.back().port = port_of(h + 1);
    std::vector<Corner> right{{a, port_of(h + 2)}};
    right.insert(right.end(), p.begin() + static_cast<std::ptrdiff_t>(apex), p.end());
    stack_.push_back(std::move(right));
    stack_.push_back(std::move(left));
  }

  const Surface& surface_;
  const RestrictedPowerDiagram& restricted_;
  const PowerDiagram& diagram_;
  const Port chunk_;
  std::vector<Port>& inside_;
  std::vector<Corner> border_, polygon_;
  std::vector<std::vector<Corner>> stack_;
  std::vector<Index> used_;  // sites in this face's dual so far, sorted
  Vec3 origin_, x_axis_, y_axis_;
};

}  // namespace

HalfEdgeComplex dual_complex(const Surface& surface, const RestrictedPowerDiagram& restricted,
                             const PowerDiagram& diagram) {
  constexpr std::size_t kChunk = 1024;
  const std::size_t faces = surface.triangles.size(), chunks = (faces + kChunk - 1) / kChunk;
  std::vector<Port> inside(2 * restricted.cell.size());  // across each side of a crossing, inside the face
  std::vector<FaceFiller> fillers;
  fillers.reserve(chunks);
  for (std::size_t c = 0; c < chunks; ++c) fillers.emplace_back(surface, restricted, diagram, c, inside);
  parallel_chunks(faces, kChunk, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) fillers[chunk].fill(static_cast<Index>(f));
  });

  HalfEdgeComplex dual;
  std::vector<Index> offset(1, 0);
  for (const FaceFiller& f : fillers) offset.push_back(offset.back() + static_cast<Index>(f.site.size()));
  dual.site.reserve(offset.back());
  dual.twin.resize(offset.back());
  dual.point.reserve(offset.back() / 3);
  for (const FaceFiller& f : fillers) {
    dual.site.insert(dual.site.end(), f.site.begin(), f.site.end());
    dual.point.insert(dual.point.end(), f.point.begin(), f.point.end());
  }
  parallel_each(chunks, [&](std::size_t chunk) {
    const auto& across = fillers[chunk].across;
    for (std::size_t k = 0; k < across.size(); ++k) {
      Port p = across[k];
      // An arc may cross several faces before it ends. It ends at a triple point because it starts at one.
      while (is_side(p)) p = inside[side_of(p) ^ 1];
      dual.twin[offset[chunk] + static_cast<Index>(k)] = offset[p >> 32] + static_cast<Index>(p & 0xffffffff);
    }
  });
  return dual;
}

}  // namespace filmsticking
