// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "arguments.h"
#include "filters/filter_options.h"

namespace filmsticking::app {

/// Adds the options of the filters, under a heading of their own.
void add_filters(Arguments& arguments, filters::FilterOptions& options);

/// The names of the filters that run, in their order: "sor, voxel".
std::string names_of(const filters::FilterOptions& options);

}  // namespace filmsticking::app
