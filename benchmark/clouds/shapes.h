// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "filmsticking/types.h"

namespace filmsticking::bench {

/// Whether `name` is one of the generated shapes, like "sphere" or "slab:1", and not a file.
bool is_shape(const std::string& name);

/// A closed, outward mesh; the README lists the names. The K of "slab:K" and its like is a size in spacings,
/// where `points` of them on the whole area have the spacing sqrt(area / points). Throws
/// std::invalid_argument for a K that is not positive and finite, or too large for the shape.
Mesh make_shape(const std::string& name, std::int64_t points);

}  // namespace filmsticking::bench
