// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "surface.h"

namespace filmsticking::mesh_report {

/// A piece that shares no vertex with others.
struct Component {
  std::int64_t faces = 0;
  bool closed = false;
  double area = 0;
  std::optional<double> volume;  ///< signed; only if it is closed and oriented. Of a cavity negative
};

/// All components, the largest area first.
std::vector<Component> components(const Surface& surface);

}  // namespace filmsticking::mesh_report
