// SPDX-License-Identifier: GPL-3.0-or-later
// Files of points and of meshes, by their extension.
#pragma once

#include <string>

#include "model.h"

namespace filmsticking::io {

/// Reads .pcd, .ply, .obj, .xyz, .txt, .stl or .vtk. Throws IoError; so it does for a file without points.
Model read_model(const std::string& path);

/// Whether write_model() knows the path's extension: .ply, .obj, .stl or .vtk.
bool can_write_model(const std::string& path);

/// Writes every coordinate so that it reads back as the same number. Throws IoError.
void write_model(const std::string& path, const Model& model);

}  // namespace filmsticking::io
