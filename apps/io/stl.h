// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "model.h"

namespace filmsticking::io {

/// An STL file: binary where single precision, all that it has, keeps every coordinate; else text.
std::string encode_stl(const Model& model);

}  // namespace filmsticking::io
