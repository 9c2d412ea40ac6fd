// SPDX-License-Identifier: GPL-3.0-or-later
// Clouds and meshes as PCL has them: pcl::PCLPointCloud2 and pcl::PolygonMesh, with every field of their
// file.
#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/PolygonMesh.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bytes.h"
#include "filmsticking/types.h"

namespace filmsticking::io {

/// Red, green, blue: 0 to 255.
using Colour = std::array<std::uint8_t, 3>;

/// Points with every field of their file, and the sensor's position where the file says it.
struct Cloud {
  pcl::PCLPointCloud2 points;  ///< x, y, z are FLOAT32 or FLOAT64: the file's values, bit for bit
  std::optional<Point> viewpoint = std::nullopt;
  std::optional<std::array<double, 4>> orientation = std::nullopt;  ///< of the sensor: a quaternion w x y z
  std::vector<Point> viewpoints = {};   ///< of each point, where its sensor was; empty if unknown
  std::vector<std::string> notes = {};  ///< how the file was read, where that is not plain: sentences
};

/// Whether all three coordinates are.
bool is_finite(const Point& p);

/// The float next to x; the largest for what is beyond, but finite.
float to_float(double x);

/// Refuses a cloud whose fields do not lie within a point, or whose points do not lie within its bytes.
/// Throws IoError.
void check_fields(const pcl::PCLPointCloud2& cloud);

/// Number of points: width times height.
std::size_t size_of(const pcl::PCLPointCloud2& cloud);

/// The field of this name, or null.
const pcl::PCLPointField* find_field(const pcl::PCLPointCloud2& cloud, const char* name);

/// The bytes of one point; `point` is less than size_of().
const std::uint8_t* bytes_of(const pcl::PCLPointCloud2& cloud, std::size_t point);

/// Reads and writes x, y and z in the bytes of a point.
class PositionFields {
 public:
  /// The cloud must have x, y and z, all FLOAT32 or all FLOAT64. Its fields must lie within a point, and its
  /// points within its bytes. Throws IoError.
  explicit PositionFields(const pcl::PCLPointCloud2& cloud);

  /// Whether the fields are FLOAT32.
  bool single() const { return single_; }

  /// The position in double precision, which changes no value.
  Point load(const std::uint8_t* point) const {
    Point position;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::uint8_t* value = point + offsets_[axis];
      position[axis] = single_ ? double{io::load<float>(value)} : io::load<double>(value);
    }
    return position;
  }

  /// Rounds the position to the fields' type.
  void store(const Point& position, std::uint8_t* point) const;

 private:
  std::array<std::size_t, 3> offsets_{};
  bool single_ = true;
};

/// Positions of all points in double precision, which changes no value. Empty for a cloud without points.
/// Throws IoError as PositionFields does.
std::vector<Point> positions_of(const pcl::PCLPointCloud2& cloud);

/// Colours of all points, from the field rgb or rgba; empty if there is none.
std::vector<Colour> colours_of(const pcl::PCLPointCloud2& cloud);

/// The fields of where the sensor of a point was, where the file has no such fields but says it otherwise.
constexpr const char* kStationFields[3] = {"_vp_x", "_vp_y", "_vp_z"};

/// Whether the name is one of kStationFields; or one of these or vp_x, vp_y, vp_z.
bool is_station(const std::string& name);
bool is_viewpoint(const std::string& name);

/// Where the sensor of each point was, from the fields vp_x, vp_y, vp_z of any number types, or those of
/// kStationFields; empty if one is missing.
std::vector<Point> viewpoints_of(const pcl::PCLPointCloud2& cloud);

/// Whether FLOAT32 keeps the value of every coordinate. Throws IoError as PositionFields does.
bool float_exact(const pcl::PCLPointCloud2& cloud);

/// A field of one value, or `count` values, of a type of PCLPointField.
pcl::PCLPointField make_field(const std::string& name, std::size_t offset, std::uint8_t type,
                              std::size_t count = 1);

/// A cloud of zeros in one row. Throws IoError for more bytes than a row of PCL can have, 4 GB.
pcl::PCLPointCloud2 make_rows(std::vector<pcl::PCLPointField> fields, std::size_t point_step,
                              std::size_t points);

/// An unorganized cloud of positions: FLOAT32 if that keeps every value, else FLOAT64. `colours`: empty, or
/// one a position; they become the field rgb.
pcl::PCLPointCloud2 make_cloud(const std::vector<Point>& positions, const std::vector<Colour>& colours = {});

/// The cloud with other positions, one a point, of type FLOAT64, in one row. All other fields are kept.
pcl::PCLPointCloud2 with_positions(const pcl::PCLPointCloud2& cloud, const std::vector<Point>& positions);

/// The cloud with its positions rounded to FLOAT32, and all other fields.
pcl::PCLPointCloud2 with_float_positions(pcl::PCLPointCloud2 cloud);

/// Whether FLOAT32 tells the points apart: no two of different places become one, none moves by more than a
/// millionth of the box's diagonal, and coordinates that are whole thousandths, or tenths of them, keep their
/// digits. Points that are not finite do not count. Throws IoError as PositionFields does.
bool float_suffices(const pcl::PCLPointCloud2& cloud);

/// The cloud with the fields of kStationFields: where each point was seen from.
pcl::PCLPointCloud2 with_stations(const pcl::PCLPointCloud2& cloud, const std::vector<Point>& stations);

/// The cloud without the fields of kStationFields and without their bytes.
pcl::PCLPointCloud2 without_stations(const pcl::PCLPointCloud2& cloud);

/// The cloud with the fields of kStationFields as vp_x, vp_y, vp_z, which files keep.
pcl::PCLPointCloud2 with_named_stations(pcl::PCLPointCloud2 cloud);

/// The cloud with the fields normal_x, normal_y and normal_z, FLOAT32; all other fields, and rows, are kept.
/// `normals`: one a point. Throws IoError as make_rows() does.
pcl::PCLPointCloud2 with_normals(const pcl::PCLPointCloud2& cloud,
                                 const std::vector<std::array<float, 3>>& normals);

/// Points of the cloud, with all their bytes, in one row.
pcl::PCLPointCloud2 select(const pcl::PCLPointCloud2& cloud, const std::vector<int>& points);

/// Triangles of polygons with three corners each.
std::vector<Triangle> triangles_of(const std::vector<pcl::Vertices>& polygons);

/// Polygons of triangles.
std::vector<pcl::Vertices> polygons_of(const std::vector<Triangle>& triangles);

/// A mesh of vertices and triangles.
pcl::PolygonMesh make_mesh(pcl::PCLPointCloud2 vertices, const std::vector<Triangle>& triangles);

}  // namespace filmsticking::io
