// SPDX-License-Identifier: GPL-3.0-or-later
// Between the messages of ROS and PCL's types, where pcl_conversions needs help.
#pragma once

#include <geometry_msgs/Transform.h>
#include <pcl_conversions/pcl_conversions.h>
#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/Marker.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

#include "io/bytes.h"
#include "io/cloud.h"
#include "io/point_layout.h"
#include "stream/frame.h"
#include "stream/shading.h"

namespace filmsticking::stream {

/// The cloud of a message with all fields, as io::PointLayout makes them of any names and types, in this
/// machine's byte order. Throws io::IoError for a message that contradicts itself, or has no x, y and z.
inline pcl::PCLPointCloud2 to_cloud(const sensor_msgs::PointCloud2& message) {
  pcl::PCLPointCloud2 cloud;
  pcl_conversions::toPCL(message, cloud);
  if (io::size_of(cloud) == 0) return cloud;
  io::check_fields(cloud);
  io::Notes notes;
  if (!cloud.is_bigendian) return io::with_known_fields(std::move(cloud), notes);
  std::set<std::uint32_t> turned;  // rgb and rgba may be the same bytes
  for (const pcl::PCLPointField& field : cloud.fields) {
    if (!turned.insert(field.offset).second) continue;
    const auto size = static_cast<std::ptrdiff_t>(io::size_of(io::Scalar{field.datatype}));
    for (std::size_t i = 0; i < io::size_of(cloud); ++i) {
      std::uint8_t* number = cloud.data.data() + (io::bytes_of(cloud, i) - cloud.data.data()) + field.offset;
      for (std::uint32_t k = 0; k < std::max(1U, field.count); ++k, number += size)
        std::reverse(number, number + size);
    }
  }
  cloud.is_bigendian = false;
  return io::with_known_fields(std::move(cloud), notes);
}

/// A list of triangles but for its header: grey, or with a shaded colour for each corner if the mesh has
/// colours. A mesh without triangles gives a request to delete the marker.
inline visualization_msgs::Marker to_marker(const pcl::PolygonMesh& polygons) {
  const Mesh mesh{io::positions_of(polygons.cloud), io::triangles_of(polygons.polygons)};
  const std::vector<io::Colour> colours = io::colours_of(polygons.cloud);
  const std::vector<float> light = colours.empty() ? std::vector<float>() : shades(mesh);
  visualization_msgs::Marker marker;
  marker.ns = "filmsticking";
  marker.type = visualization_msgs::Marker::TRIANGLE_LIST;
  marker.action =
      mesh.triangles.empty() ? visualization_msgs::Marker::DELETE : visualization_msgs::Marker::ADD;
  marker.pose.orientation.w = 1;
  marker.scale.x = marker.scale.y = marker.scale.z = 1;
  marker.color.r = marker.color.g = marker.color.b = 0.75f;
  marker.color.a = 1;
  for (const Triangle& t : mesh.triangles)
    for (const std::int32_t vertex : t) {
      auto& corner = marker.points.emplace_back();
      corner.x = mesh.positions[vertex][0];
      corner.y = mesh.positions[vertex][1];
      corner.z = mesh.positions[vertex][2];
      if (colours.empty()) continue;
      auto& colour = marker.colors.emplace_back();
      colour.r = light[vertex] * colours[vertex][0] / 255.0f;
      colour.g = light[vertex] * colours[vertex][1] / 255.0f;
      colour.b = light[vertex] * colours[vertex][2] / 255.0f;
      colour.a = 1;
    }
  return marker;
}

inline Pose to_pose(const geometry_msgs::Transform& transform) {
  const auto& q = transform.rotation;
  const auto& t = transform.translation;
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
  pose.translation() << t.x, t.y, t.z;
  return pose;
}

}  // namespace filmsticking::stream
