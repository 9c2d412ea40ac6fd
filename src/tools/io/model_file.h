// SPDX-License-Identifier: GPL-3.0-or-later
// Files of points and of meshes, by their extension.
#pragma once

#include <cstdint>
#include <string>

#include "model.h"

namespace filmsticking::io {

/// Reads points from .pcd, .ply, .obj, .stl (the vertices of a mesh), .xyz or .txt. Broken files are refused,
/// and so are those without points and those of more bytes than `most`, as by read_file(). Throws IoError.
Model read_cloud(const std::string& path, std::int64_t most = 0);

/// Reads a mesh from .ply, .obj, .stl or .vtk (this one by VTK, which trusts it). A file without triangles is
/// refused. Throws IoError.
Model read_mesh(const std::string& path);

/// Reads whatever is there, points or a mesh or nothing, from a file that read_cloud() or read_mesh() takes.
/// Throws IoError.
Model read_model(const std::string& path);

/// Whether write_model() knows the path's extension: .ply, .obj, .stl, .vtk or .glb.
bool can_write_model(const std::string& path);

/// Writes every coordinate so that it reads back as the same number, but for .glb. Throws IoError.
void write_model(const std::string& path, const Model& model);

}  // namespace filmsticking::io
