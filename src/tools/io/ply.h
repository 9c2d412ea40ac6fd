// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "byte_writer.h"
#include "model.h"

namespace filmsticking::io {

/// Reads a PLY file (ascii, binary of either byte order): x, y, z in any type, red, green, blue as bytes,
/// faces; whatever else it holds is skipped. Throws IoError.
Model decode_ply(std::string_view bytes);

/// A binary little-endian PLY file; coordinates are float where that keeps every value, else double.
void encode_ply(const Model& model, ByteWriter& out);

}  // namespace filmsticking::io
