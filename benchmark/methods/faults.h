// SPDX-License-Identifier: GPL-3.0-or-later
// Methods that fail in all ways that compare must survive.
#pragma once

#include <vector>

#include "method.h"

namespace filmsticking::bench {

Outcome run_fault_crash(const std::vector<Point>& points, int threads);
Outcome run_fault_hang(const std::vector<Point>& points, int threads);
Outcome run_fault_throw(const std::vector<Point>& points, int threads);
Outcome run_fault_memory(const std::vector<Point>& points, int threads);

}  // namespace filmsticking::bench
