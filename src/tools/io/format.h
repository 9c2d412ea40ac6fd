// SPDX-License-Identifier: GPL-3.0-or-later
// Formats by name, for bytes that have no file name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "byte_writer.h"
#include "model.h"

namespace filmsticking::io {

/// The formats of points, as extensions without a dot: pcd ply obj stl xyz txt.
const std::vector<std::string>& cloud_formats();

/// The formats that encode_model() writes: ply obj stl vtk glb.
const std::vector<std::string>& mesh_formats();

/// The format of points that the bytes begin like; empty if none. Text of numbers is xyz.
std::string detect_format(std::string_view bytes);

/// Points, and triangles if any, of a format of cloud_formats() or vtk. Throws IoError.
Model decode_cloud(const std::string& format, std::string_view bytes);
/// The same; gives the bytes' memory back as soon as they are not needed.
Model decode_cloud(const std::string& format, std::string&& bytes);

/// Sends the bytes of a file of a format of mesh_formats(). Every coordinate reads back as the same number,
/// but for glb. Throws IoError, at a model that the format cannot hold before anything is sent.
void encode_model(const std::string& format, const Model& model, const ByteSink& sink);
/// The same bytes in one piece.
std::string encode_model(const std::string& format, const Model& model);

}  // namespace filmsticking::io
