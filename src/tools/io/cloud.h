// SPDX-License-Identifier: GPL-3.0-or-later
// Clouds and meshes as PCL has them: pcl::PCLPointCloud2 and pcl::PolygonMesh, with every field of their
// file.
#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/Vertices.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "filmsticking/types.h"

namespace filmsticking::io {

/// Red, green, blue: 0 to 255.
using Colour = std::array<std::uint8_t, 3>;

/// Points with every field of their file, and the sensor's position where the file says it.
struct Cloud {
  pcl::PCLPointCloud2 points;  ///< x, y, z are FLOAT32 or FLOAT64: the file's values, bit for bit
  std::optional<Point> viewpoint;
};

/// Number of points: width times height.
std::size_t size_of(const pcl::PCLPointCloud2& cloud);

/// The field of this name, or null.
const pcl::PCLPointField* find_field(const pcl::PCLPointCloud2& cloud, const char* name);

/// Positions of all points in double precision, which changes no value. x, y, z must be FLOAT32 or FLOAT64
/// and lie within the points. Throws IoError.
std::vector<Point> positions_of(const pcl::PCLPointCloud2& cloud);

/// Colours of all points, from the field rgb or rgba; empty if there is none.
std::vector<Colour> colours_of(const pcl::PCLPointCloud2& cloud);

/// An unorganized cloud of positions: FLOAT32 if that keeps every value, else FLOAT64. `colours`: empty, or
/// one a position; they become the field rgb.
pcl::PCLPointCloud2 make_cloud(const std::vector<Point>& positions, const std::vector<Colour>& colours = {});

/// Triangles of polygons with three corners each.
std::vector<Triangle> triangles_of(const std::vector<pcl::Vertices>& polygons);

/// Polygons of triangles.
std::vector<pcl::Vertices> polygons_of(const std::vector<Triangle>& triangles);

}  // namespace filmsticking::io
