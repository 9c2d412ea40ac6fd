// SPDX-License-Identifier: GPL-3.0-or-later
// Files of points and of meshes: by their extension, or by a format's name where bytes have no file name.
#pragma once

#include <pcl/PolygonMesh.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "bytes.h"
#include "cloud.h"
#include "point_layout.h"

namespace filmsticking::io {

/// How a file of points is read.
struct ReadOptions {
  std::int64_t most = 0;    ///< bytes, as of read_file()
  std::string format = {};  ///< of cloud_formats(); empty: by the content
  std::vector<std::string> columns =
      {};                              ///< names of the columns of a text, "_" for none; empty: by the text
  bool columns_of_texts_only = false;  ///< other formats are read as ever, with a note; else they are refused
};

/// The names of the formats of points: pcd ply obj stl vtk off las ptx pts xyz txt csv asc grid. pts, xyz,
/// txt, csv and asc are the same: tables as text.
const std::vector<std::string>& cloud_formats();

/// The formats that write_cloud() writes: pcd ply xyz txt.
const std::vector<std::string>& written_cloud_formats();

/// The formats that encode_mesh() writes: ply obj stl vtk glb.
const std::vector<std::string>& mesh_formats();

/// The extensions of formats, with dots and spaces between, as messages list them: ".ply .obj".
std::string extensions_of(const std::vector<std::string>& formats);

/// The format of points that the bytes begin like; empty if none. Text of numbers is xyz.
std::string detect_format(std::string_view bytes);

/// Points, with all their fields, of a format of cloud_formats(). `columns` as in ReadOptions. Throws
/// IoError.
Cloud decode_cloud(const std::string& format, std::string_view bytes,
                   const std::vector<std::string>& columns = {});

/// The same with the triangles, if any. `notes`, if any, is set.
pcl::PolygonMesh decode_mesh(const std::string& format, std::string_view bytes, Notes* notes = nullptr);

/// Sends the bytes of a file of a format of mesh_formats(). Every coordinate reads back as the same number,
/// but for glb. PLY keeps all fields, the others colours alone, STL none. Throws IoError, at a mesh that the
/// format cannot hold before anything is sent.
void encode_mesh(const std::string& format, const pcl::PCLPointCloud2& vertices,
                 const std::vector<Triangle>& triangles, const ByteSink& sink);

/// The same bytes in one piece.
std::string encode_mesh(const std::string& format, const pcl::PolygonMesh& mesh);

/// Points of a file with this extension (".las"; empty: it has no name), whose content says the format unless
/// the options do. Broken files are refused, and so are files without points, and formats that are not read,
/// with the tool that converts them. Throws IoError.
Cloud decode_any(std::string_view bytes, const std::string& extension, const ReadOptions& options = {});

/// The same of a file; files of more bytes than options.most are refused. Throws IoError.
Cloud read_cloud(const std::string& path, const ReadOptions& options = {});

/// Reads a mesh of triangles by its content, its vertices with all their fields. A file without triangles is
/// refused. Throws IoError.
pcl::PolygonMesh read_mesh(const std::string& path);

/// Reads points, a mesh or nothing by the content. Throws IoError.
pcl::PolygonMesh read_model(const std::string& path);

/// Whether write_mesh() knows the path's extension: .ply, .obj, .stl, .vtk or .glb.
bool can_write_mesh(const std::string& path);

/// Writes a file as encode_mesh() does. Throws IoError.
void write_mesh(const std::string& path, const pcl::PCLPointCloud2& vertices,
                const std::vector<Triangle>& triangles);
void write_mesh(const std::string& path, const pcl::PolygonMesh& mesh);

/// Whether write_cloud() knows the path's extension: .pcd, .ply, .xyz or .txt.
bool can_write_cloud(const std::string& path);

/// Writes points with all fields to .pcd (binary) or .ply, with positions and normals alone to .xyz or .txt.
/// Every coordinate reads back as the same number. Throws IoError.
void write_cloud(const std::string& path, const Cloud& cloud);

}  // namespace filmsticking::io
