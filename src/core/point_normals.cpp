// SPDX-License-Identifier: GPL-3.0-or-later
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

#include "filmsticking/normals.h"
#include "geometry/nearest.h"
#include "geometry/parallel.h"
#include "geometry/surface.h"
#include "geometry/work_limits.h"
#include "surface/vertex_normals.h"

namespace filmsticking {
namespace {

// The farthest place whose nearest is sought, in sizes of the surface. Squares of more lose all digits.
constexpr double kFar = 1e6;
// Points between two looks for a request to stop.
constexpr std::size_t kChunk = 1024;

// Maps the box of some points to one of longest side 1 around the origin.
class Frame {
 public:
  Frame(const PointsView& points, const std::vector<std::int32_t>& vertices) {
    for (const std::int32_t v : vertices) box_.extend(half(points[static_cast<std::size_t>(v)]));
    const double side = box_.sizes().maxCoeff();
    if (side > 0) scale_ = 1 / side;
  }
  Vec3 operator()(const Point& p) const { return (half(p) - box_.center()) * scale_; }

 private:
  static Vec3 half(const Point& p) { return Vec3(p[0], p[1], p[2]) / 2; }  // a box of halves is finite

  Eigen::AlignedBox3d box_;
  double scale_ = 1;
};

bool is_finite(const Point& p) { return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]); }

bool fits(const PointsView& points, const std::vector<std::int32_t>& vertices,
          const std::vector<Triangle>& triangles) {
  const auto below = [](std::int32_t i, std::size_t end) {
    return i >= 0 && static_cast<std::size_t>(i) < end;
  };
  return !triangles.empty() && std::all_of(vertices.begin(), vertices.end(), [&](std::int32_t v) {
    return below(v, points.size()) && is_finite(points[static_cast<std::size_t>(v)]);
  }) && std::all_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](std::int32_t v) { return below(v, vertices.size()); });
  });
}

// The corners' normals, mixed by the areas that a place on the face cuts off.
Vec3 normal_at(const Surface& surface, const std::vector<Vec3>& normals, const SurfaceTree::Hit& hit) {
  const Corners& t = surface.triangles[hit.triangle];
  Vec3 sum = Vec3::Zero();
  for (int k = 0; k < 3; ++k) {
    const Vec3 p = surface.corner(hit.triangle, (k + 1) % 3), q = surface.corner(hit.triangle, (k + 2) % 3);
    sum += (p - hit.point).cross(q - hit.point).norm() * normals[t[k]];
  }
  const double norm = sum.norm();
  return norm > 0 ? Vec3(sum / norm) : normals[t[0]];
}

Normal rounded(const Vec3& n) {
  return {static_cast<float>(n.x()), static_cast<float>(n.y()), static_cast<float>(n.z())};
}

void fill(const PointsView& points, const std::vector<std::int32_t>& vertices,
          const std::vector<Triangle>& triangles, const Cancel& cancel, std::vector<Normal>& normals) {
  const Frame frame(points, vertices);
  Surface surface;
  surface.triangles.assign(triangles.begin(), triangles.end());
  surface.positions.resize(vertices.size());
  parallel_each(vertices.size(), [&](std::size_t k) {
    surface.positions[k] = frame(points[static_cast<std::size_t>(vertices[k])]);
  });
  const std::vector<Vec3> of_vertex = vertex_normals(surface, cancel);

  const float nan = std::numeric_limits<float>::quiet_NaN();
  normals.assign(points.size(), Normal{nan, nan, nan});
  std::vector<char> done(points.size(), 0);
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const auto i = static_cast<std::size_t>(vertices[k]);
    normals[i] = rounded(of_vertex[k]), done[i] = 1;
  }
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!done[i] && is_finite(points[i])) others.push_back(i);
  if (others.empty()) return;
  const SurfaceTree tree(surface);
  parallel_chunks(others.size(), kChunk, [&](std::size_t, std::size_t begin, std::size_t end) {
    cancel();
    for (std::size_t k = begin; k < end; ++k) {
      Vec3 place = frame(points[others[k]]);
      if (const double far = place.cwiseAbs().maxCoeff(); far > kFar) place *= kFar / far;
      normals[others[k]] = rounded(normal_at(surface, of_vertex, tree.nearest(place)));
    }
  });
}

}  // namespace

Status point_normals(const PointsView& points, const std::vector<std::int32_t>& vertices,
                     const std::vector<Triangle>& triangles, std::vector<Normal>& normals, int threads,
                     const std::atomic<bool>* cancel) noexcept {
  Status status = Status::Ok;
  normals.clear();
  if (!fits(points, vertices, triangles)) return Status::InvalidInput;
  try {
    tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
    arena.execute([&] { fill(points, vertices, triangles, {cancel}, normals); });
  } catch (const Cancelled&) {
    status = Status::Cancelled;
  } catch (const std::bad_alloc&) {
    status = Status::OutOfMemory;
  } catch (...) {
    status = Status::InternalError;
  }
  if (status != Status::Ok) normals.clear();
  return status;
}

}  // namespace filmsticking
