// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "filmsticking/options.h"

namespace filmsticking {

/// For so many points. Throws Failure: Status::InvalidOptions where a value is out of its range,
/// Status::InvalidGuidingSurface where a film would start from a given surface that is no closed oriented
/// 2-manifold.
void check_options(const Options& options, std::size_t points);

}  // namespace filmsticking
