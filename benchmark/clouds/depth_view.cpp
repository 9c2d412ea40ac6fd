// SPDX-License-Identifier: GPL-3.0-or-later
#include "depth_view.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "random.h"

namespace filmsticking::bench {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Tree = CGAL::AABB_tree<
    CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>>>;

constexpr double kNoMatter = 0.01;  // the area of a piece, of the square of the size of the pieces
constexpr int kFirstPixels = 50;    // from the middle of the first image to its edges
constexpr int kImages = 20;         // at most, to find the size of the pixels
constexpr double kTooMany = 0.01;   // hits, that are left out
constexpr double kDistance = 2;     // of the camera, in diagonals
constexpr double kBehind =
    1e-9;  // share of the distance by which a visible point may be behind the first hit

Kernel::Point_3 cgal_point(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

class DepthCamera {
 public:
  DepthCamera(const Mesh& mesh, std::uint64_t seed) {
    Eigen::AlignedBox3d box;
    for (const Point& p : mesh.positions) box.extend(Vec3(p[0], p[1], p[2]));
    Random random(seed);
    Vec3 ahead;
    for (double& x : ahead) x = random.gauss();
    ahead_ = ahead.normalized();
    right_ = ahead_.unitOrthogonal();
    up_ = right_.cross(ahead_);
    eye_ = box.center() - kDistance * box.diagonal().norm() * ahead_;
    const auto corner = [&](std::int32_t v) {
      const Point& p = mesh.positions[static_cast<std::size_t>(v)];
      return Vec3(p[0], p[1], p[2]);
    };
    for (const Triangle& t : mesh.triangles) {
      const Vec3 a = corner(t[0]), b = corner(t[1]), c = corner(t[2]);
      if ((b - a).cross(c - a).norm() > 0)
        triangles_.emplace_back(cgal_point(a), cgal_point(b), cgal_point(c));
    }
    tree_.insert(triangles_.cbegin(), triangles_.cend());
    tree_.build();
  }

  const Triangles& triangles() const { return triangles_; }

  /// Of half the field of view, which holds the box.
  static double extent() { return std::tan(std::asin(0.5 / kDistance)); }

  /// The first hits through pixels of this size, at distance 1, row by row.
  std::vector<Sample> image(double pixel) const {
    std::vector<Sample> hits;
    const auto half = static_cast<std::int64_t>(extent() / pixel);
    for (std::int64_t v = -half; v <= half; ++v)
      for (std::int64_t u = -half; u <= half; ++u) {
        const Vec3 ray = ahead_ + pixel * (static_cast<double>(u) * right_ + static_cast<double>(v) * up_);
        if (const std::optional<Sample> hit = first_hit(ray)) hits.push_back(*hit);
      }
    return hits;
  }

  Eigen::Isometry3d frame() const {
    Eigen::Matrix3d axes;
    axes << right_, -up_, ahead_;
    Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
    frame.linear() = axes.transpose();
    frame.translation() = -(axes.transpose() * eye_);
    return frame;
  }

  bool sees(const Vec3& p) const {
    const std::optional<Sample> hit = first_hit(p - eye_);
    return !hit || (hit->position - eye_).norm() >= (1 - kBehind) * (p - eye_).norm();
  }

 private:
  std::optional<Sample> first_hit(const Vec3& ray) const {
    const Kernel::Ray_3 line(cgal_point(eye_), Kernel::Vector_3(ray.x(), ray.y(), ray.z()));
    const auto hit = tree_.first_intersection(line);
    if (!hit) return std::nullopt;
    const auto* at = boost::get<Kernel::Point_3>(&hit->first);
    if (at == nullptr) return std::nullopt;  // along the face
    const Kernel::Vector_3 n =
        CGAL::normal(hit->second->vertex(0), hit->second->vertex(1), hit->second->vertex(2));
    return Sample{Vec3(at->x(), at->y(), at->z()), Vec3(n.x(), n.y(), n.z()).normalized()};
  }

  Vec3 eye_, ahead_, right_, up_;
  Triangles triangles_;
  Tree tree_;
};

}  // namespace

std::vector<Sample> sample_depth_view(const Mesh& mesh, std::size_t count, std::uint64_t seed) {
  const DepthCamera camera(mesh, seed);
  // As many hits as pixels that the mesh covers: one over the square of their size.
  double pixel = DepthCamera::extent() / kFirstPixels;
  std::vector<Sample> hits = camera.image(pixel);
  for (int i = 0; i < kImages && !(hits.size() >= count && hits.size() <= (1 + kTooMany) * count); ++i) {
    const double share = std::max<double>(hits.size(), 0.25) / ((1 + kTooMany / 2) * count);
    pixel *= std::sqrt(std::max(share, 1e-4));
    hits = camera.image(pixel);
  }
  if (hits.size() < count) throw std::invalid_argument("the camera sees too little of the mesh");
  Random random(seed);
  random.shuffle(hits);
  hits.resize(count);
  return hits;
}

Eigen::Isometry3d depth_camera_frame(const Mesh& mesh, std::uint64_t seed) {
  return DepthCamera(mesh, seed).frame();
}

Mesh visible_part(const Mesh& mesh, std::uint64_t seed, double size) {
  const DepthCamera camera(mesh, seed);
  Mesh seen;
  const auto add = [&](const std::array<Vec3, 3>& t) {
    for (const Vec3& p : t) seen.positions.push_back({p.x(), p.y(), p.z()});
    const auto n = static_cast<std::int32_t>(seen.positions.size());
    seen.triangles.push_back({n - 3, n - 2, n - 1});
  };
  std::vector<std::array<Vec3, 3>> open;
  for (const Kernel::Triangle_3& face : camera.triangles()) {
    std::array<Vec3, 3> whole;
    for (int k = 0; k < 3; ++k)
      whole[static_cast<std::size_t>(k)] = Vec3(face[k].x(), face[k].y(), face[k].z());
    open.assign(1, whole);
    while (!open.empty()) {  // ends: the longest side is halved, down to `size`
      const std::array<Vec3, 3> t = open.back();
      open.pop_back();
      std::size_t longest = 0;
      double length = 0;
      for (std::size_t k = 0; k < 3; ++k)
        if (const double side = (t[(k + 1) % 3] - t[k]).norm(); side > length) longest = k, length = side;
      const double area = (t[1] - t[0]).cross(t[2] - t[0]).norm() / 2;
      if (length <= size || area <= kNoMatter * size * size) {
        if (camera.sees((t[0] + t[1] + t[2]) / 3)) add(t);
        continue;
      }
      const std::size_t next = (longest + 1) % 3, last = (longest + 2) % 3;
      const Vec3 middle = (t[longest] + t[next]) / 2;
      open.push_back({t[longest], middle, t[last]});
      open.push_back({middle, t[next], t[last]});
    }
  }
  return seen;
}

}  // namespace filmsticking::bench
