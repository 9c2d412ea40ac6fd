// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string_view>

#include "model.h"

namespace filmsticking::io {

/// Reads a PCD file (ascii, binary, compressed): x, y, z in any type, and rgb or rgba. Unlike PCL's reader it
/// stands broken files. Calls `release`, if there is one, when compressed data are unpacked and `bytes` are
/// not looked at any more. Throws IoError.
Model decode_pcd(std::string_view bytes, const std::function<void()>& release = nullptr);

}  // namespace filmsticking::io
