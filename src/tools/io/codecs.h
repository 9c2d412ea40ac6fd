// SPDX-License-Identifier: GPL-3.0-or-later
// One decoder and one encoder a format. Decoders take bytes from anywhere: broken ones give an IoError.
// Polygons become fans of triangles whose corners are vertices of the mesh.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "bytes.h"
#include "cloud.h"
#include "point_layout.h"

namespace filmsticking::io {

/// What a file of a mesh has; `notes` say what is left out.
struct Shape {
  pcl::PCLPointCloud2 points;
  std::vector<Triangle> triangles = {};
  Notes notes = {};
};

/// A PCD file (ascii, binary, binary_compressed) with all fields, as PointLayout makes them. The order of the
/// header's lines is free.
Cloud decode_pcd(std::string_view bytes);

/// A PLY file (ascii, binary of either byte order) with all scalar properties of the vertices, as PointLayout
/// makes them. Lists of vertices and other elements are skipped.
Shape decode_ply(std::string_view bytes);

/// Vertices, with colours and normals where every vertex has one, and faces of a Wavefront OBJ file.
Shape decode_obj(std::string_view bytes);

/// An STL file, binary or text; equal corners become one vertex.
Shape decode_stl(std::string_view bytes);

/// Points, polygons and triangle strips of a legacy VTK file of polygonal data, or the points of an
/// unstructured or structured grid, text or binary, up to version 5.1. The first scalars of three or four
/// unsigned bytes are colours. All else is skipped. Source of the format: "VTK File Formats" of the VTK
/// User's Guide.
Shape decode_vtk(std::string_view bytes);

/// A table of points as text, one a line. `columns`: names of its columns, "_" for none; empty: they are
/// taken from the file's header, or from what the columns can be, and notes say so. Named columns are kept as
/// fields. Comments, headings and a trailer are skipped; lines that do not fit the others are refused.
Cloud decode_xyz(std::string_view bytes, const std::vector<std::string>& columns = {});

/// The stations of a Leica PTX file, moved by their matrices, with intensities, and colours where all
/// have them. Points without a return (0 0 0) are not finite. The fields of kStationFields have each point's
/// station.
Cloud decode_ptx(std::string_view bytes);

/// A station of a PTX file.
struct Station {
  pcl::PCLPointCloud2 points;   ///< in its own coordinates
  std::array<double, 16> pose;  ///< to the world's, row by row, for columns
};

/// The stations one by one.
std::vector<Station> decode_stations(std::string_view bytes);

/// Whether the text begins as PTX files do.
bool is_ptx(std::string_view bytes);

/// The cells of an Esri ASCII grid of heights that have a height, at their centres.
Cloud decode_grid(std::string_view bytes);

/// The vertices, with colours and normals, and faces of an OFF file (OFF, COFF, NOFF, CNOFF, STOFF).
Shape decode_off(std::string_view bytes);

/// A LAS file 1.0 to 1.4 of point formats 0 to 10 with colours, intensity, classification and time.
/// Coordinates are the doubles nearest to their decimals. LAZ is refused.
/// Source of the format: "LAS Specification 1.4 - R15", ASPRS.
Cloud decode_las(std::string_view bytes);

/// A binary little-endian PLY file with all fields of the vertices: the inverse of decode_ply(). Coordinates
/// are float where that keeps every value, else double. 64-bit integers, which PLY lacks, become double.
void encode_ply(const pcl::PCLPointCloud2& vertices, const std::vector<Triangle>& triangles, ByteWriter& out);

/// A Wavefront OBJ file with colours; every coordinate in the shortest text that reads back the same.
void encode_obj(const pcl::PCLPointCloud2& vertices, const std::vector<Triangle>& triangles, ByteWriter& out);

/// An STL file: binary where single precision, all that it has, keeps every coordinate; else text.
void encode_stl(const pcl::PCLPointCloud2& vertices, const std::vector<Triangle>& triangles, ByteWriter& out);

/// A binary legacy VTK file (version 4.2, which all readers know) with double coordinates and colours.
void encode_vtk(const pcl::PCLPointCloud2& vertices, const std::vector<Triangle>& triangles, ByteWriter& out);

/// A binary glTF 2.0 file with positions, triangles and colours, these in linear light as glTF has them. Its
/// coordinates have single precision; where that is not enough, they count from the middle of the box, to
/// which the mesh's node is moved. Throws IoError for a mesh without triangles, or a coordinate that is not
/// finite or out of range.
void encode_glb(const pcl::PCLPointCloud2& vertices, const std::vector<Triangle>& triangles, ByteWriter& out);

/// A binary PCD file (version 0.7) with all fields: the inverse of decode_pcd().
void encode_pcd(const Cloud& cloud, ByteWriter& out);

/// A text with one point a line: x, y, z, and normals if there are any; every number in the shortest text
/// that reads back the same.
void encode_xyz(const Cloud& cloud, ByteWriter& out);

/// Appends a polygon as a fan of triangles.
void append_polygon(const std::vector<std::int32_t>& corners, std::vector<Triangle>& triangles);

/// Refuses a word of a text file that should be a number; `word` lies in `file`. Throws IoError.
[[noreturn]] void throw_no_number(std::string_view file, std::string_view word);

/// A file's number of a vertex, from zero. Throws IoError if it cannot be one.
std::int32_t corner_index(double value);

/// Refuses corners that are no vertices; at the end, as faces may come before points. Throws IoError.
void check_corners(const std::vector<Triangle>& triangles, std::size_t vertices);

}  // namespace filmsticking::io
