// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "row.h"

namespace filmsticking::bench {

/// Markdown: for every kind and size of cloud, and every shape if `by_shape`, a table of quality and one of
/// cost, with a row a method. The README explains the columns.
std::string quality_tables(const std::vector<Row>& rows, const std::vector<std::string>& methods,
                           const std::string& peer, bool by_shape);

}  // namespace filmsticking::bench
