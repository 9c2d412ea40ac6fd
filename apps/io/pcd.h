// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "model.h"

namespace filmsticking::io {

/// Reads a PCD file (ascii, binary, compressed): x, y, z in any type, and rgb or rgba. Unlike PCL's reader it
/// stands broken files. Throws IoError.
Model decode_pcd(std::string_view bytes);

}  // namespace filmsticking::io
