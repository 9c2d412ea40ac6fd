// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "model.h"

namespace filmsticking::io {

/// Reads a PCD file (ascii, binary, compressed) by PCL: x, y, z in any type, and rgb or rgba. Throws IoError.
Model read_pcd(const std::string& path);

}  // namespace filmsticking::io
