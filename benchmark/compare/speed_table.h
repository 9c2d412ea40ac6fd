// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "row.h"

namespace filmsticking::bench {

/// A method on a number of threads; 0: all.
struct Series {
  std::string method;
  int threads = 0;
};

/// Markdown: for every shape and kind of cloud the median seconds by size, the ratios to the Delaunay
/// triangulation and to the peer, the memory, the exponent of growth, and the share of each stage.
std::string speed_tables(const std::vector<Row>& rows, const std::vector<Series>& series,
                         const std::string& peer);

}  // namespace filmsticking::bench
