// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "byte_writer.h"
#include "model.h"

namespace filmsticking::io {

/// Reads an STL file, binary or text; equal corners become one vertex. Throws IoError.
Model decode_stl(std::string_view bytes);

/// An STL file: binary where single precision, all that it has, keeps every coordinate; else text.
void encode_stl(const Model& model, ByteWriter& out);

}  // namespace filmsticking::io
