// SPDX-License-Identifier: GPL-3.0-or-later
// The former names of formats.h.
#pragma once

#include "formats.h"
#include "model.h"

namespace filmsticking::io {

inline bool can_write_model(const std::string& path) { return can_write_mesh(path); }
inline void write_model(const std::string& path, const Model& model) { write_mesh(path, model); }

}  // namespace filmsticking::io
