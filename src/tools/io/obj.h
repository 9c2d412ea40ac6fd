// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "byte_writer.h"
#include "model.h"

namespace filmsticking::io {

/// Reads vertices (colours too, where every vertex has one) and faces of a Wavefront OBJ file. Throws
/// IoError.
Model decode_obj(std::string_view bytes);

/// A Wavefront OBJ file; every coordinate in the shortest text that reads back as the same number.
void encode_obj(const Model& model, ByteWriter& out);

}  // namespace filmsticking::io
