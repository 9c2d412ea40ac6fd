// SPDX-License-Identifier: GPL-3.0-or-later
#include "cloud.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>

#include "float_exact.h"
#include "io_error.h"

namespace filmsticking::io {
namespace {

template <class T>
T load_at(const std::uint8_t* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

const std::uint8_t* bytes_of(const pcl::PCLPointCloud2& cloud, std::size_t point) {
  const std::size_t row = point / cloud.width, column = point % cloud.width;
  return cloud.data.data() + row * cloud.row_step + column * cloud.point_step;
}

/// Refuses a cloud whose points do not lie within its bytes.
void check_bytes(const pcl::PCLPointCloud2& cloud) {
  const std::uint64_t row = std::uint64_t{cloud.width} * cloud.point_step;
  const bool whole = row == 0 || cloud.height == 0 ||
                     (cloud.row_step >= row &&
                      std::uint64_t{cloud.row_step} * (cloud.height - 1) + row <= cloud.data.size());
  if (!whole) throw IoError("the cloud has fewer bytes than its header says");
}

pcl::PCLPointField make_field(const char* name, std::size_t offset, std::uint8_t type) {
  pcl::PCLPointField field;
  field.name = name;
  field.offset = static_cast<std::uint32_t>(offset);
  field.datatype = type;
  field.count = 1;
  return field;
}

}  // namespace

std::size_t size_of(const pcl::PCLPointCloud2& cloud) { return std::size_t{cloud.width} * cloud.height; }

const pcl::PCLPointField* find_field(const pcl::PCLPointCloud2& cloud, const char* name) {
  const auto found = std::find_if(cloud.fields.begin(), cloud.fields.end(),
                                  [name](const pcl::PCLPointField& field) { return field.name == name; });
  return found == cloud.fields.end() ? nullptr : &*found;
}

std::vector<Point> positions_of(const pcl::PCLPointCloud2& cloud) {
  check_bytes(cloud);
  const pcl::PCLPointField* axes[3];
  const char* const names[3] = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    axes[axis] = find_field(cloud, names[axis]);
    const bool single = axes[axis] && axes[axis]->datatype == pcl::PCLPointField::FLOAT32;
    if (!single && !(axes[axis] && axes[axis]->datatype == pcl::PCLPointField::FLOAT64))
      throw IoError(std::string("the cloud has no field ") + names[axis] + " of type FLOAT32 or FLOAT64");
    if (std::uint64_t{axes[axis]->offset} + (single ? 4 : 8) > cloud.point_step)
      throw IoError(std::string("the cloud's field ") + names[axis] + " is not within a point");
  }
  std::vector<Point> positions(size_of(cloud));
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const std::uint8_t* point = bytes_of(cloud, i);
    for (int axis = 0; axis < 3; ++axis) {
      const std::uint8_t* value = point + axes[axis]->offset;
      positions[i][axis] = axes[axis]->datatype == pcl::PCLPointField::FLOAT32 ? double{load_at<float>(value)}
                                                                               : load_at<double>(value);
    }
  }
  return positions;
}

std::vector<Colour> colours_of(const pcl::PCLPointCloud2& cloud) {
  check_bytes(cloud);
  const pcl::PCLPointField* field = find_field(cloud, "rgb");
  if (!field) field = find_field(cloud, "rgba");
  if (!field || std::uint64_t{field->offset} + 4 > cloud.point_step) return {};
  std::vector<Colour> colours(size_of(cloud));
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const std::uint8_t* packed = bytes_of(cloud, i) + field->offset;  // blue, green, red, alpha
    colours[i] = {packed[2], packed[1], packed[0]};
  }
  return colours;
}

pcl::PCLPointCloud2 make_cloud(const std::vector<Point>& positions, const std::vector<Colour>& colours) {
  using Type = pcl::PCLPointField;
  const bool single = float_exact(positions);
  const std::size_t size = single ? sizeof(float) : sizeof(double);
  pcl::PCLPointCloud2 cloud;
  const char* const names[3] = {"x", "y", "z"};
  for (std::size_t axis = 0; axis < 3; ++axis)
    cloud.fields.push_back(make_field(names[axis], axis * size, single ? Type::FLOAT32 : Type::FLOAT64));
  if (!colours.empty()) cloud.fields.push_back(make_field("rgb", 3 * size, Type::FLOAT32));
  cloud.height = 1;
  cloud.width = static_cast<std::uint32_t>(positions.size());
  cloud.point_step = static_cast<std::uint32_t>(3 * size + (colours.empty() ? 0 : 4));
  cloud.row_step = cloud.width * cloud.point_step;
  cloud.is_dense = true;
  cloud.data.resize(positions.size() * cloud.point_step);
  std::uint8_t* to = cloud.data.data();
  for (std::size_t i = 0; i < positions.size(); ++i) {
    for (const double x : positions[i]) {
      const float rounded = static_cast<float>(x);
      std::memcpy(to, single ? static_cast<const void*>(&rounded) : &x, size);
      to += size;
    }
    if (colours.empty()) continue;
    const std::uint8_t packed[4] = {colours[i][2], colours[i][1], colours[i][0], 255};
    to = std::copy_n(packed, 4, to);
  }
  return cloud;
}

std::vector<Triangle> triangles_of(const std::vector<pcl::Vertices>& polygons) {
  std::vector<Triangle> triangles;
  triangles.reserve(polygons.size());
  for (const pcl::Vertices& polygon : polygons)
    triangles.push_back({polygon.vertices[0], polygon.vertices[1], polygon.vertices[2]});
  return triangles;
}

std::vector<pcl::Vertices> polygons_of(const std::vector<Triangle>& triangles) {
  std::vector<pcl::Vertices> polygons(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    polygons[t].vertices.assign(triangles[t].begin(), triangles[t].end());
  return polygons;
}

}  // namespace filmsticking::io
