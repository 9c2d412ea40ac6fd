// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "arguments.h"
#include "filters/filter_options.h"

namespace filmsticking::app {

/// The filters, as --help shows them.
boost::program_options::options_description filter_arguments();

/// Throws UsageError.
filters::FilterOptions filter_options(const Arguments& given);

/// The names of the filters that are on, in their order: "sor, voxel".
std::string names_of(const filters::FilterOptions& options);

}  // namespace filmsticking::app
