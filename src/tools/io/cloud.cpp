// SPDX-License-Identifier: GPL-3.0-or-later
#include "cloud.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <utility>

#include "bytes.h"
#include "io_error.h"
#include "large_pages.h"

namespace filmsticking::io {
namespace {

constexpr const char* kAxes[3] = {"x", "y", "z"};
constexpr const char* kViewpointAxes[3] = {"vp_x", "vp_y", "vp_z"};

/// Whether rounding keeps decimals: where all are whole multiples of 0.1, 0.01 and so on to 0.0001, the
/// rounded ones have the same digits.
bool keeps_digits(const std::vector<Point>& points) {
  for (const double digits : {1.0, 10.0, 100.0, 1e3, 1e4}) {
    bool whole = true, kept = true;
    for (std::size_t i = 0; i < points.size() && whole; ++i)
      for (const double x : points[i]) {
        const double scaled = x * digits, near = std::nearbyint(scaled);
        whole &= std::abs(scaled - near) <= 1e-15 * std::abs(scaled) + 1e-12;
        kept &= std::nearbyint(double{to_float(x)} * digits) == near;
      }
    if (whole) return kept;
  }
  return true;
}

/// Whether rounding moves no point by more than a millionth of the box's diagonal.
bool keeps_places(const std::vector<Point>& points) {
  constexpr double kMove = 1e-6;
  if (points.empty()) return true;
  Point least = points[0], most = points[0];
  double move = 0;
  for (const Point& p : points)
    for (std::size_t k = 0; k < 3; ++k) {
      least[k] = std::min(least[k], p[k]), most[k] = std::max(most[k], p[k]);
      move = std::max(move, std::abs(double{to_float(p[k])} - p[k]));
    }
  return move <= kMove * std::hypot(most[0] - least[0], most[1] - least[1], most[2] - least[2]);
}

/// Whether points of different places stay so.
bool keeps_apart(std::vector<Point>& points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const std::size_t distinct = points.size();
  for (Point& p : points)
    for (double& x : p) x = double{to_float(x)};
  std::sort(points.begin(), points.end());
  return std::unique(points.begin(), points.end()) - points.begin() == static_cast<std::ptrdiff_t>(distinct);
}

bool float_exact(const Point& p) {
  return std::all_of(p.begin(), p.end(), [](double x) { return std::isnan(x) || double{to_float(x)} == x; });
}

}  // namespace

bool is_finite(const Point& p) {
  return std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(x); });
}

float to_float(double x) {
  constexpr double kMost = std::numeric_limits<float>::max();
  return std::isfinite(x) ? static_cast<float>(std::clamp(x, -kMost, kMost)) : static_cast<float>(x);
}

void check_fields(const pcl::PCLPointCloud2& cloud) {
  for (const pcl::PCLPointField& field : cloud.fields)
    if (field.offset + std::uint64_t{size_of(Scalar{field.datatype})} * std::max(1U, field.count) >
        cloud.point_step)
      throw IoError("the cloud's field " + field.name + " is not within a point");
  const std::uint64_t row = std::uint64_t{cloud.width} * cloud.point_step;
  const std::uint64_t step = cloud.height > 1 ? cloud.row_step : row;  // one row may leave its step out
  const bool whole =
      row == 0 || cloud.height == 0 || (step >= row && step * (cloud.height - 1) + row <= cloud.data.size());
  if (!whole) throw IoError("the cloud has fewer bytes than its header says");
}

std::size_t size_of(const pcl::PCLPointCloud2& cloud) { return std::size_t{cloud.width} * cloud.height; }

const pcl::PCLPointField* find_field(const pcl::PCLPointCloud2& cloud, const char* name) {
  const auto found = std::find_if(cloud.fields.begin(), cloud.fields.end(),
                                  [name](const pcl::PCLPointField& field) { return field.name == name; });
  return found == cloud.fields.end() ? nullptr : &*found;
}

const std::uint8_t* bytes_of(const pcl::PCLPointCloud2& cloud, std::size_t point) {
  if (cloud.height == 1) return cloud.data.data() + point * cloud.point_step;
  const std::size_t row = point / cloud.width, column = point % cloud.width;
  return cloud.data.data() + row * cloud.row_step + column * cloud.point_step;
}

PositionFields::PositionFields(const pcl::PCLPointCloud2& cloud) {
  check_fields(cloud);
  for (int axis = 0; axis < 3; ++axis) {
    const pcl::PCLPointField* field = find_field(cloud, kAxes[axis]);
    const bool single = field && field->datatype == pcl::PCLPointField::FLOAT32;
    if (!single && !(field && field->datatype == pcl::PCLPointField::FLOAT64))
      throw IoError(std::string("the cloud has no field ") + kAxes[axis] + " of type FLOAT32 or FLOAT64");
    if (axis > 0 && single != single_) throw IoError("the cloud's x, y and z are not of one type");
    single_ = single;
    offsets_[axis] = field->offset;
  }
}

void PositionFields::store(const Point& position, std::uint8_t* point) const {
  for (int axis = 0; axis < 3; ++axis) {
    const float rounded = single_ ? static_cast<float>(position[axis]) : 0;
    if (single_) {
      std::memcpy(point + offsets_[axis], &rounded, sizeof rounded);
    } else {
      std::memcpy(point + offsets_[axis], &position[axis], sizeof position[axis]);
    }
  }
}

std::vector<Point> positions_of(const pcl::PCLPointCloud2& cloud) {
  if (size_of(cloud) == 0) return {};
  const PositionFields fields(cloud);
  std::vector<Point> positions(size_of(cloud));
  for (std::size_t i = 0; i < positions.size(); ++i) positions[i] = fields.load(bytes_of(cloud, i));
  return positions;
}

std::vector<Colour> colours_of(const pcl::PCLPointCloud2& cloud) {
  check_fields(cloud);
  const pcl::PCLPointField* field = find_field(cloud, "rgb");
  if (!field) field = find_field(cloud, "rgba");
  if (!field || size_of(Scalar{field->datatype}) != 4) return {};
  std::vector<Colour> colours(size_of(cloud));
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const std::uint8_t* packed = bytes_of(cloud, i) + field->offset;  // blue, green, red, alpha
    colours[i] = {packed[2], packed[1], packed[0]};
  }
  return colours;
}

bool is_station(const std::string& name) {
  return std::find(std::begin(kStationFields), std::end(kStationFields), name) != std::end(kStationFields);
}

bool is_viewpoint(const std::string& name) {
  return is_station(name) ||
         std::find(std::begin(kViewpointAxes), std::end(kViewpointAxes), name) != std::end(kViewpointAxes);
}

std::vector<Point> viewpoints_of(const pcl::PCLPointCloud2& cloud) {
  check_fields(cloud);
  for (const auto& names : {kViewpointAxes, kStationFields}) {
    std::array<const pcl::PCLPointField*, 3> axes{};
    for (int axis = 0; axis < 3; ++axis) {
      axes[axis] = find_field(cloud, names[axis]);
      if (axes[axis] && size_of(Scalar{axes[axis]->datatype}) == 0) axes[axis] = nullptr;
    }
    if (!axes[0] || !axes[1] || !axes[2]) continue;
    std::vector<Point> places(size_of(cloud));
    for (std::size_t i = 0; i < places.size(); ++i)
      for (int axis = 0; axis < 3; ++axis)
        places[i][axis] = io::load(bytes_of(cloud, i) + axes[axis]->offset, Scalar{axes[axis]->datatype});
    return places;
  }
  return {};
}

bool float_exact(const pcl::PCLPointCloud2& cloud) {
  const PositionFields fields(cloud);
  for (std::size_t i = 0; !fields.single() && i < size_of(cloud); ++i)
    if (!float_exact(fields.load(bytes_of(cloud, i)))) return false;
  return true;
}

pcl::PCLPointField make_field(const std::string& name, std::size_t offset, std::uint8_t type,
                              std::size_t count) {
  pcl::PCLPointField field;
  field.name = name;
  field.offset = static_cast<std::uint32_t>(offset);
  field.datatype = type;
  field.count = static_cast<std::uint32_t>(count);
  return field;
}

pcl::PCLPointCloud2 make_rows(std::vector<pcl::PCLPointField> fields, std::size_t point_step,
                              std::size_t points) {
  if (points > std::numeric_limits<std::uint32_t>::max() / std::max<std::size_t>(point_step, 1))
    throw IoError("its points take more than 4 GB");
  pcl::PCLPointCloud2 cloud;
  cloud.fields = std::move(fields);
  cloud.height = 1;
  cloud.width = static_cast<std::uint32_t>(points);
  cloud.point_step = static_cast<std::uint32_t>(point_step);
  cloud.row_step = cloud.width * cloud.point_step;
  cloud.is_dense = true;
  cloud.data.reserve(points * point_step);
  prefer_large_pages(cloud.data.data(), points * point_step);
  cloud.data.resize(points * point_step);
  return cloud;
}

pcl::PCLPointCloud2 make_cloud(const std::vector<Point>& positions, const std::vector<Colour>& colours) {
  using Type = pcl::PCLPointField;
  const bool single =
      std::all_of(positions.begin(), positions.end(), [](const Point& p) { return float_exact(p); });
  const std::size_t size = single ? sizeof(float) : sizeof(double), rgb = 3 * size;
  std::vector<pcl::PCLPointField> fields;
  for (std::size_t axis = 0; axis < 3; ++axis)
    fields.push_back(make_field(kAxes[axis], axis * size, single ? Type::FLOAT32 : Type::FLOAT64));
  if (!colours.empty()) fields.push_back(make_field("rgb", rgb, Type::FLOAT32));
  pcl::PCLPointCloud2 cloud = make_rows(std::move(fields), rgb + (colours.empty() ? 0 : 4), positions.size());
  const PositionFields places(cloud);
  std::uint8_t* to = cloud.data.data();
  for (std::size_t i = 0; i < positions.size(); ++i, to += cloud.point_step) {
    places.store(positions[i], to);
    if (colours.empty()) continue;
    const std::uint8_t packed[4] = {colours[i][2], colours[i][1], colours[i][0], 255};
    std::copy_n(packed, 4, to + rgb);
  }
  return cloud;
}

pcl::PCLPointCloud2 with_positions(const pcl::PCLPointCloud2& cloud, const std::vector<Point>& positions) {
  constexpr std::size_t kAhead = sizeof(Point);
  std::vector<pcl::PCLPointField> fields;
  for (std::size_t axis = 0; axis < 3; ++axis)
    fields.push_back(make_field(kAxes[axis], axis * sizeof(double), pcl::PCLPointField::FLOAT64));
  for (const pcl::PCLPointField& field : cloud.fields)
    if (std::find(kAxes, kAxes + 3, field.name) == kAxes + 3)
      fields.push_back(make_field(field.name, kAhead + field.offset, field.datatype, field.count));
  pcl::PCLPointCloud2 moved = make_rows(std::move(fields), kAhead + cloud.point_step, positions.size());
  moved.header = cloud.header;
  std::uint8_t* to = moved.data.data();
  for (std::size_t i = 0; i < positions.size(); ++i, to += moved.point_step) {
    std::memcpy(to, positions[i].data(), kAhead);
    std::copy_n(bytes_of(cloud, i), cloud.point_step, to + kAhead);
  }
  return moved;
}

pcl::PCLPointCloud2 with_stations(const pcl::PCLPointCloud2& cloud, const std::vector<Point>& stations) {
  std::vector<pcl::PCLPointField> fields = cloud.fields;
  for (std::size_t axis = 0; axis < 3; ++axis)
    fields.push_back(make_field(kStationFields[axis], cloud.point_step + axis * sizeof(double),
                                pcl::PCLPointField::FLOAT64));
  pcl::PCLPointCloud2 placed =
      make_rows(std::move(fields), cloud.point_step + sizeof(Point), stations.size());
  std::uint8_t* to = placed.data.data();
  for (std::size_t i = 0; i < stations.size(); ++i, to += placed.point_step) {
    std::copy_n(bytes_of(cloud, i), cloud.point_step, to);
    std::memcpy(to + cloud.point_step, stations[i].data(), sizeof(Point));
  }
  return placed;
}

pcl::PCLPointCloud2 without_stations(const pcl::PCLPointCloud2& cloud) {
  std::vector<pcl::PCLPointField> fields;
  std::vector<std::size_t> from;
  std::size_t step = 0;
  for (const pcl::PCLPointField& field : cloud.fields) {
    if (is_station(field.name)) continue;
    from.push_back(field.offset);
    fields.push_back(make_field(field.name, step, field.datatype, std::max(1U, field.count)));
    step += size_of(Scalar{field.datatype}) * std::max(1U, field.count);
  }
  if (fields.size() == cloud.fields.size()) return cloud;
  pcl::PCLPointCloud2 plain = make_rows(fields, step, size_of(cloud));
  plain.header = cloud.header;
  for (std::size_t i = 0; i < size_of(cloud); ++i)
    for (std::size_t k = 0; k < fields.size(); ++k)
      std::copy_n(bytes_of(cloud, i) + from[k], size_of(Scalar{fields[k].datatype}) * fields[k].count,
                  plain.data.data() + i * step + fields[k].offset);
  return plain;
}

pcl::PCLPointCloud2 with_named_stations(pcl::PCLPointCloud2 cloud) {
  for (pcl::PCLPointField& field : cloud.fields)
    if (is_station(field.name)) field.name.erase(0, 1);
  return cloud;
}

pcl::PCLPointCloud2 with_float_positions(pcl::PCLPointCloud2 cloud) {
  const PositionFields fields(cloud);
  if (fields.single()) return cloud;
  for (std::size_t i = 0; i < size_of(cloud); ++i) {
    std::uint8_t* const point = cloud.data.data() + (bytes_of(cloud, i) - cloud.data.data());
    const Point p = fields.load(point);
    for (int axis = 0; axis < 3; ++axis) {
      const float rounded = to_float(p[axis]);
      std::memcpy(point + find_field(cloud, kAxes[axis])->offset, &rounded, sizeof rounded);
    }
  }
  for (pcl::PCLPointField& field : cloud.fields)
    if (std::find(kAxes, kAxes + 3, field.name) != kAxes + 3) field.datatype = pcl::PCLPointField::FLOAT32;
  return cloud;
}

bool float_suffices(const pcl::PCLPointCloud2& cloud) {
  const PositionFields fields(cloud);
  if (fields.single()) return true;
  std::vector<Point> points = positions_of(cloud);
  points.erase(std::remove_if(points.begin(), points.end(), [](const Point& p) { return !is_finite(p); }),
               points.end());
  return keeps_digits(points) && keeps_places(points) && keeps_apart(points);
}

pcl::PCLPointCloud2 with_normals(const pcl::PCLPointCloud2& cloud,
                                 const std::vector<std::array<float, 3>>& normals) {
  constexpr const char* kNames[3] = {"normal_x", "normal_y", "normal_z"};
  std::vector<pcl::PCLPointField> fields;
  for (const pcl::PCLPointField& field : cloud.fields)
    if (std::find(kNames, kNames + 3, field.name) == kNames + 3) fields.push_back(field);
  for (std::size_t axis = 0; axis < 3; ++axis)
    fields.push_back(
        make_field(kNames[axis], cloud.point_step + axis * sizeof(float), pcl::PCLPointField::FLOAT32));
  constexpr std::size_t kMore = sizeof normals[0];
  pcl::PCLPointCloud2 all = make_rows(std::move(fields), cloud.point_step + kMore, normals.size());
  all.header = cloud.header;
  all.width = cloud.width, all.height = cloud.height;
  all.row_step = all.width * all.point_step;
  std::uint8_t* to = all.data.data();
  for (std::size_t i = 0; i < normals.size(); ++i) {
    to = std::copy_n(bytes_of(cloud, i), cloud.point_step, to);
    std::memcpy(to, normals[i].data(), kMore);
    to += kMore;
  }
  return all;
}

pcl::PCLPointCloud2 select(const pcl::PCLPointCloud2& cloud, const std::vector<int>& points) {
  pcl::PCLPointCloud2 some = make_rows(cloud.fields, cloud.point_step, points.size());
  some.header = cloud.header;
  std::uint8_t* to = some.data.data();
  for (const int point : points)
    to = std::copy_n(bytes_of(cloud, static_cast<std::size_t>(point)), cloud.point_step, to);
  return some;
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

pcl::PolygonMesh make_mesh(pcl::PCLPointCloud2 vertices, const std::vector<Triangle>& triangles) {
  pcl::PolygonMesh mesh;
  mesh.header = vertices.header;
  mesh.cloud = std::move(vertices);
  mesh.polygons = polygons_of(triangles);
  return mesh;
}

}  // namespace filmsticking::io
