// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filter_options.h"
#include "io/model.h"

namespace filmsticking::filters {

/// Runs the chosen filters on the points of a model and drops its triangles; without any, gives it back as it
/// is. Points that `crop` and `sor` keep have the very value that they had, in double precision; so large
/// coordinates lose nothing. Throws FilterError as the filter of clouds does.
io::Model filter(const io::Model& model, const FilterOptions& options);

}  // namespace filmsticking::filters
