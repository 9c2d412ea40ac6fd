// SPDX-License-Identifier: GPL-3.0-or-later
// Between the messages of ROS and our own types.
//
// Templates over the messages' types, without a header of ROS: sensor_msgs/PointCloud2, pcl_msgs/PolygonMesh,
// visualization_msgs/Marker and geometry_msgs/Transform have the same members in every ROS.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/model.h"
#include "stream/live_frame.h"
#include "stream/shading.h"

namespace filmsticking::stream {

/// A message that contradicts itself or lacks what is needed; what() is a sentence without its full stop.
struct MessageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

namespace detail {

/// The numbers that sensor_msgs/PointField gives to the types used here.
enum FieldType : std::uint8_t { kUInt32 = 6, kFloat32 = 7, kFloat64 = 8 };

/// Reads a number of a message in the byte order of the message. This machine's is the little-endian one.
template <typename T>
T load(const std::uint8_t* bytes, bool big_endian) {
  std::uint8_t raw[sizeof(T)];
  for (std::size_t k = 0; k < sizeof raw; ++k) raw[k] = bytes[big_endian ? sizeof raw - 1 - k : k];
  T value;
  std::memcpy(&value, raw, sizeof value);
  return value;
}

/// Where a number is in a point's bytes.
struct Place {
  std::size_t offset = 0;
  std::uint8_t type = 0;
};

/// Throws MessageError for a field that is not within a point.
template <class PointCloud2>
std::optional<Place> find(const PointCloud2& cloud, const char* name) {
  for (const auto& field : cloud.fields) {
    if (field.name != name) continue;
    const std::uint64_t size = field.datatype == kFloat64 ? 8 : 4;
    if (field.offset + size > cloud.point_step)
      throw MessageError(std::string("the cloud's field ") + name + " is not within a point");
    return Place{field.offset, field.datatype};
  }
  return {};
}

}  // namespace detail

/// The points of a sensor_msgs/PointCloud2: x, y, z of either precision, and the field rgb or rgba. Points
/// that are not finite are left out. Other fields are not read. Throws MessageError.
template <class PointCloud2>
io::Model to_model(const PointCloud2& cloud) {
  using namespace detail;
  Place axes[3];
  for (int axis = 0; axis < 3; ++axis) {
    const char* names[] = {"x", "y", "z"};
    const std::optional<Place> place = find(cloud, names[axis]);
    if (!place || (place->type != kFloat32 && place->type != kFloat64))
      throw MessageError(std::string("the cloud has no field ") + names[axis] +
                         " of type FLOAT32 or FLOAT64");
    axes[axis] = *place;
  }
  std::optional<Place> colour = find(cloud, "rgb");
  if (!colour) colour = find(cloud, "rgba");
  if (colour && colour->type != kFloat32 && colour->type != kUInt32) colour.reset();

  const std::uint64_t row = std::uint64_t{cloud.width} * cloud.point_step;
  const bool one_row = cloud.height == 1;  // drivers are careless with the length of an only row
  const std::uint64_t row_step = one_row ? row : std::uint64_t{cloud.row_step};
  if (row_step < row) throw MessageError("the cloud's rows are shorter than their points");
  if (cloud.height > 0 && row_step * (cloud.height - 1) + row > cloud.data.size())
    throw MessageError("the cloud has fewer bytes than its header tells");

  io::Model model;
  if (row == 0) return model;  // whatever the height
  for (std::uint64_t y = 0; y < cloud.height; ++y)
    for (std::uint64_t x = 0; x < cloud.width; ++x) {
      const std::uint8_t* point = cloud.data.data() + y * row_step + x * cloud.point_step;
      Point p;
      bool finite = true;
      for (int axis = 0; axis < 3; ++axis) {
        const std::uint8_t* bytes = point + axes[axis].offset;
        p[axis] = axes[axis].type == kFloat64 ? load<double>(bytes, cloud.is_bigendian)
                                              : double{load<float>(bytes, cloud.is_bigendian)};
        finite = finite && std::isfinite(p[axis]);
      }
      if (!finite) continue;
      model.positions.push_back(p);
      if (!colour) continue;
      const auto packed = load<std::uint32_t>(point + colour->offset, cloud.is_bigendian);
      model.colours.push_back({static_cast<std::uint8_t>(packed >> 16),
                               static_cast<std::uint8_t>(packed >> 8), static_cast<std::uint8_t>(packed)});
    }
  return model;
}

/// Fills a sensor_msgs/PointCloud2 but for its header: x, y, z of single precision, and rgb where the model
/// has colours.
template <class PointCloud2>
void to_cloud(const io::Model& model, PointCloud2& cloud) {
  const bool coloured = !model.colours.empty();
  const char* names[] = {"x", "y", "z", "rgb"};
  cloud.fields.resize(coloured ? 4 : 3);
  for (std::size_t k = 0; k < cloud.fields.size(); ++k) {
    cloud.fields[k].name = names[k];
    cloud.fields[k].offset = static_cast<std::uint32_t>(4 * k);
    cloud.fields[k].datatype = detail::kFloat32;
    cloud.fields[k].count = 1;
  }
  cloud.height = 1;
  cloud.width = static_cast<std::uint32_t>(model.positions.size());
  cloud.point_step = static_cast<std::uint32_t>(4 * cloud.fields.size());
  cloud.row_step = cloud.width * cloud.point_step;
  cloud.is_bigendian = false;
  cloud.is_dense = true;
  cloud.data.resize(std::size_t{cloud.width} * cloud.point_step);
  std::uint8_t* to = cloud.data.data();
  for (std::size_t k = 0; k < model.positions.size(); ++k) {
    for (const double x : model.positions[k]) {
      const float single = static_cast<float>(x);
      std::memcpy(to, &single, 4);
      to += 4;
    }
    if (!coloured) continue;
    const io::Colour& c = model.colours[k];
    const std::uint32_t packed = 0xff000000u | std::uint32_t{c[0]} << 16 | std::uint32_t{c[1]} << 8 | c[2];
    std::memcpy(to, &packed, 4);
    to += 4;
  }
}

/// Fills a pcl_msgs/PolygonMesh but for its headers.
template <class PolygonMesh>
void to_polygon_mesh(const io::Model& model, PolygonMesh& mesh) {
  to_cloud(model, mesh.cloud);
  mesh.polygons.resize(model.triangles.size());
  for (std::size_t k = 0; k < model.triangles.size(); ++k) {
    const Triangle& t = model.triangles[k];
    mesh.polygons[k].vertices.assign(t.begin(), t.end());
  }
}

/// The mesh of a pcl_msgs/PolygonMesh, its polygons as fans of triangles. Throws MessageError, also where
/// indices are out of range.
template <class PolygonMesh>
io::Model to_mesh_model(const PolygonMesh& mesh) {
  io::Model model = to_model(mesh.cloud);
  if (model.positions.size() != std::size_t{mesh.cloud.width} * mesh.cloud.height)
    throw MessageError("the mesh has vertices that are not finite");
  for (const auto& polygon : mesh.polygons) {
    for (const auto vertex : polygon.vertices)
      if (vertex >= model.positions.size())
        throw MessageError("a polygon has a vertex that the mesh does not have");
    for (std::size_t k = 2; k < polygon.vertices.size(); ++k)
      model.triangles.push_back({static_cast<std::int32_t>(polygon.vertices[0]),
                                 static_cast<std::int32_t>(polygon.vertices[k - 1]),
                                 static_cast<std::int32_t>(polygon.vertices[k])});
  }
  return model;
}

/// Fills a visualization_msgs/Marker but for its header: a list of triangles, where the model has colours
/// with one, shaded, for each corner, else grey; without triangles, a request to take the marker off.
template <class Marker>
void to_marker(const io::Model& model, Marker& marker) {
  marker.ns = "filmsticking";
  marker.id = 0;
  marker.type = Marker::TRIANGLE_LIST;
  marker.action = model.triangles.empty() ? Marker::DELETE : Marker::ADD;
  marker.pose.orientation.w = 1;
  marker.scale.x = marker.scale.y = marker.scale.z = 1;
  marker.color.r = marker.color.g = marker.color.b = 0.75f;
  marker.color.a = 1;
  marker.points.resize(3 * model.triangles.size());
  marker.colors.resize(model.colours.empty() ? 0 : marker.points.size());
  const std::vector<float> light = model.colours.empty() ? std::vector<float>() : shades(model);
  std::size_t corner = 0;
  for (const Triangle& t : model.triangles)
    for (const std::int32_t vertex : t) {
      marker.points[corner].x = model.positions[vertex][0];
      marker.points[corner].y = model.positions[vertex][1];
      marker.points[corner].z = model.positions[vertex][2];
      if (!model.colours.empty()) {
        marker.colors[corner].r = light[vertex] * model.colours[vertex][0] / 255.0f;
        marker.colors[corner].g = light[vertex] * model.colours[vertex][1] / 255.0f;
        marker.colors[corner].b = light[vertex] * model.colours[vertex][2] / 255.0f;
        marker.colors[corner].a = 1;
      }
      ++corner;
    }
}

/// A geometry_msgs/Transform.
template <class Transform>
Pose to_pose(const Transform& transform) {
  const auto& q = transform.rotation;
  const auto& t = transform.translation;
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
  pose.translation() << t.x, t.y, t.z;
  return pose;
}

}  // namespace filmsticking::stream
