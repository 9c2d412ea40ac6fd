// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "model.h"

namespace filmsticking::io {

/// Reads a text with one point a line: x, y, z, and anything after them, separated by blanks, commas or
/// semicolons. Lines that begin with # or //, empty ones, and a heading before the first point are skipped.
/// Columns 4 to 6 are colours if they are whole numbers from 0 to 255 in every line and more than 0 and 1
/// occur. Throws IoError.
Model decode_xyz(std::string_view bytes);

}  // namespace filmsticking::io
