// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include "filmsticking/types.h"

namespace filmsticking::test {

/// The share of the area that shows its front to its sensor. `sensor_of`: where a place was seen from.
template <class SensorOf>
double facing_share(const Mesh& mesh, const SensorOf& sensor_of) {
  const auto at = [&](std::int32_t v) {
    return Eigen::Vector3d(mesh.positions[static_cast<std::size_t>(v)].data());
  };
  double front = 0, all = 0;
  for (const Triangle& t : mesh.triangles) {
    const Eigen::Vector3d area = (at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0]));
    const Eigen::Vector3d middle = (at(t[0]) + at(t[1]) + at(t[2])) / 3;
    const Point sensor = sensor_of(Point{middle.x(), middle.y(), middle.z()});
    all += area.norm();
    if (area.dot(Eigen::Vector3d(sensor.data()) - middle) > 0) front += area.norm();
  }
  return all > 0 ? front / all : 0;
}

}  // namespace filmsticking::test
