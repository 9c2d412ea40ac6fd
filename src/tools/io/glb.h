// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "byte_writer.h"
#include "model.h"

namespace filmsticking::io {

/// A binary glTF 2.0 file with the mesh's positions, triangles and colours, these in linear light as glTF has
/// them. Its coordinates have single precision; where that is not enough, they count from the middle of the
/// box, to which the mesh's node is moved. Throws IoError for a model that has no triangles, or a coordinate
/// that is not finite or out of range.
void encode_glb(const Model& model, ByteWriter& out);

}  // namespace filmsticking::io
