// SPDX-License-Identifier: GPL-3.0-or-later
// Range images of a mesh, as a scanner beside a turntable takes them.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "filmsticking/types.h"

namespace filmsticking::test {

/// The first hits of a grid of rays from the sensor.
struct RangeImage {
  Eigen::Isometry3d pose;               ///< sensor to world
  std::vector<Eigen::Vector3d> points;  ///< in the sensor's coordinates, whose z is the middle ray
};

/// Casts rays, `pitch` apart at this distance along the sensor's z, at all triangles and keeps the nearest
/// hit of each. All of the mesh is before the sensor.
inline RangeImage cast_rays(const Mesh& mesh, const Eigen::Isometry3d& pose, double distance, double pitch) {
  const Eigen::Isometry3d to_sensor = pose.inverse();
  std::vector<Eigen::Vector3d> corners;  // their places where all rays are parallel, and 1 / z
  Eigen::Vector2d least(1e300, 1e300), most(-1e300, -1e300);
  for (const Point& p : mesh.positions) {
    const Eigen::Vector3d q = to_sensor * Eigen::Vector3d(p[0], p[1], p[2]);
    corners.emplace_back(q.x() * distance / q.z(), q.y() * distance / q.z(), 1 / q.z());
    least = least.cwiseMin(corners.back().head<2>());
    most = most.cwiseMax(corners.back().head<2>());
  }
  const int width = static_cast<int>((most.x() - least.x()) / pitch) + 1;
  const int height = static_cast<int>((most.y() - least.y()) / pitch) + 1;
  constexpr double kNothing = 0;
  std::vector<double> nearness(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), kNothing);
  for (const Triangle& t : mesh.triangles) {
    const Eigen::Vector3d &a = corners[t[0]], &b = corners[t[1]], &c = corners[t[2]];
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    if (std::abs(normal.z()) < 1e-300) continue;  // parallel to the rays
    const Eigen::Vector3d low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    const int x_end = static_cast<int>((high.x() - least.x()) / pitch);
    const int y_end = static_cast<int>((high.y() - least.y()) / pitch);
    for (int y = static_cast<int>((low.y() - least.y()) / pitch); y <= y_end; ++y)
      for (int x = static_cast<int>((low.x() - least.x()) / pitch); x <= x_end; ++x) {
        const Eigen::Vector2d ray(least.x() + x * pitch, least.y() + y * pitch);
        const auto side = [&ray](const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
          return (q.x() - p.x()) * (ray.y() - p.y()) - (q.y() - p.y()) * (ray.x() - p.x());
        };
        const double ab = side(a, b), bc = side(b, c), ca = side(c, a);
        if (!((ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0))) continue;
        const double z =
            a.z() - ((ray.x() - a.x()) * normal.x() + (ray.y() - a.y()) * normal.y()) / normal.z();
        double& nearest = nearness[static_cast<std::size_t>(y * width + x)];
        nearest = std::max(nearest, z);
      }
  }
  RangeImage image{pose, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double z = 1 / nearness[static_cast<std::size_t>(y * width + x)];
      if (std::isfinite(z))
        image.points.emplace_back((least.x() + x * pitch) * z / distance,
                                  (least.y() + y * pitch) * z / distance, z);
    }
  return image;
}

/// Images from a full turn about the mesh's y axis and one about its x axis, each in equal steps.
inline std::vector<RangeImage> turntable(const Mesh& mesh, int steps, double pitch) {
  constexpr double kDistance = 5;
  std::vector<RangeImage> images;
  for (const Eigen::Vector3d& axis : {Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(1, 0, 0)})
    for (int k = 0; k < steps; ++k) {
      const Eigen::Isometry3d pose(Eigen::AngleAxisd(2 * M_PI * k / steps, axis) *
                                   Eigen::Translation3d(0, 0, -kDistance));
      images.push_back(cast_rays(mesh, pose, kDistance, pitch));
    }
  return images;
}

/// Writes a binary PCD file; `viewpoint`: the sensor's pose, or null for the identity.
inline void write_pcd(const std::string& path, const std::vector<Eigen::Vector3d>& points,
                      const Eigen::Isometry3d* viewpoint = nullptr) {
  const Eigen::Isometry3d pose = viewpoint ? *viewpoint : Eigen::Isometry3d::Identity();
  const Eigen::Vector3d t = pose.translation();
  const Eigen::Quaterniond q(pose.linear());
  char header[600];
  std::snprintf(header, sizeof header,
                "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH %zu\n"
                "HEIGHT 1\nVIEWPOINT %.9g %.9g %.9g %.9g %.9g %.9g %.9g\nPOINTS %zu\nDATA binary\n",
                points.size(), t.x(), t.y(), t.z(), q.w(), q.x(), q.y(), q.z(), points.size());
  std::ofstream file(path, std::ios::binary);
  file << header;
  for (const Eigen::Vector3d& p : points) {
    const float xyz[3] = {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
    file.write(reinterpret_cast<const char*>(xyz), sizeof xyz);
  }
}

}  // namespace filmsticking::test
