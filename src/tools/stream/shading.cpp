// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>

namespace filmsticking::stream {

std::vector<float> shades(const Mesh& mesh) {
  std::vector<Eigen::Vector3d> normals(mesh.positions.size(), Eigen::Vector3d::Zero());  // by area
  for (const Triangle& t : mesh.triangles) {
    const Eigen::Vector3d a(mesh.positions[t[0]].data()), b(mesh.positions[t[1]].data()),
        c(mesh.positions[t[2]].data());
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    for (const std::int32_t vertex : t) normals[vertex] += normal;
  }
  const Eigen::Vector3d lamp = Eigen::Vector3d(1, 0.5, 2).normalized();
  std::vector<float> shades;
  shades.reserve(normals.size());
  for (const Eigen::Vector3d& normal : normals)
    shades.push_back(static_cast<float>(0.75 + 0.25 * normal.normalized().dot(lamp)));
  return shades;
}

}  // namespace filmsticking::stream
