// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "byte_writer.h"
#include "model.h"

namespace filmsticking::io {

/// Points, polygons and triangle strips of a legacy VTK file of polygonal data, text or binary, of any
/// version to 5.1, and the points' colours: their first attribute that is scalars of three or four unsigned
/// bytes, or COLOR_SCALARS. All else is passed over. The source of the format is "VTK File Formats" of the
/// VTK User's Guide. Throws IoError.
Model decode_vtk(std::string_view bytes);

/// A binary legacy VTK file (version 4.2, which all readers know) with double coordinates.
void encode_vtk(const Model& model, ByteWriter& out);

}  // namespace filmsticking::io
