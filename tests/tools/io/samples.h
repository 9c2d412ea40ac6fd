// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/bytes.h"
#include "io/codecs.h"
#include "io/formats.h"
#include "io/io_error.h"
#include "support/model.h"
#include "support/scratch_folder.h"

namespace filmsticking::test {

using io::Colour;
using io::IoError;

/// A tetrahedron with awkward coordinates, in double or rounded to single precision.
inline Model tetrahedron(bool single) {
  Model model;
  model.positions = {{1.0 / 3, -2e-7, 500000.1234567891},
                     {M_PI, 1e-30, 4649776.224740001},
                     {-0.1, 7.25, 4649776.2},
                     {0, 1e17 / 7, -1.0 / 7}};
  if (single)
    for (Point& p : model.positions)
      for (double& x : p) x = static_cast<float>(x);
  model.colours = {Colour{0, 1, 2}, Colour{253, 254, 255}, Colour{127, 128, 129}, Colour{10, 200, 30}};
  model.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return model;
}

/// The same bits: -0 is not 0.
inline bool same_bits(const std::vector<Point>& a, const std::vector<Point>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Point)) == 0;
}

/// The corners of the triangles, one after the other.
inline std::vector<Point> corners(const Model& model) {
  std::vector<Point> points;
  for (const Triangle& t : model.triangles)
    for (const int k : t) points.push_back(model.positions[k]);
  return points;
}

inline void write_text(const std::string& path, std::string_view text) {
  std::ofstream(path, std::ios::binary) << text;
}

inline std::string error_of(const std::string& path) {
  try {
    io::read_cloud(path);
  } catch (const IoError& error) {
    return error.what();
  }
  return "";
}

/// Every point with normals, a label and rows, in double or single precision.
inline io::Cloud labelled(bool single) {
  const std::vector<Point> places = tetrahedron(single).positions;
  io::Cloud cloud{
      io::with_normals(io::make_cloud(places), {{0, 0, 1}, {0, 1, 0}, {0.6F, 0, -0.8F}, {1, 0, 0}}),
      Point{1, 2, 1.0 / 3}};
  cloud.points.width = cloud.points.height = 2;
  cloud.points.row_step = 2 * cloud.points.point_step;
  return cloud;
}

inline std::vector<std::array<float, 3>> normals_in(const pcl::PCLPointCloud2& cloud) {
  std::vector<std::array<float, 3>> normals(io::size_of(cloud));
  for (std::size_t i = 0; i < normals.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) {
      const char* names[] = {"normal_x", "normal_y", "normal_z"};
      const pcl::PCLPointField* field = io::find_field(cloud, names[axis]);
      if (field == nullptr) return {};
      normals[i][static_cast<std::size_t>(axis)] = io::load<float>(io::bytes_of(cloud, i) + field->offset);
    }
  return normals;
}

/// The value of a field at a point, as its own type.
template <typename T>
T value_of(const pcl::PCLPointCloud2& cloud, const char* name, std::size_t point) {
  const pcl::PCLPointField* field = io::find_field(cloud, name);
  T value{};
  if (field) std::memcpy(&value, io::bytes_of(cloud, point) + field->offset, sizeof value);
  return value;
}

inline std::vector<std::pair<std::string, int>> fields_of(const pcl::PCLPointCloud2& cloud) {
  std::vector<std::pair<std::string, int>> fields;
  for (const pcl::PCLPointField& field : cloud.fields) fields.emplace_back(field.name, field.datatype);
  return fields;
}

}  // namespace filmsticking::test
