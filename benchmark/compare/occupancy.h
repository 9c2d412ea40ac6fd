// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "filmsticking/types.h"

namespace filmsticking::bench {

/// A place, and whether it is inside the true solid.
struct Probe {
  Point place;
  bool inside;
};

/// Of a file of float32 numbers in this machine's order: x, y, z, and 1 inside or 0 outside, again and again.
/// Throws std::runtime_error.
std::vector<Probe> read_probes(const std::string& path);

/// How the solid of a mesh fills the true one, by probes.
struct Overlap {
  double iou = 0;      ///< inside both, as a share of inside either
  double missing = 0;  ///< of the truth
  double extra = 0;    ///< as a share of the truth
};

/// Nothing for a mesh that has no inside: it is not closed, or not manifold.
std::optional<Overlap> overlap(const Mesh& mesh, const std::vector<Probe>& probes);

}  // namespace filmsticking::bench
