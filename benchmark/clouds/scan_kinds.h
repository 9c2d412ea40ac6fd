// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "filmsticking/types.h"

namespace filmsticking::bench {

/// A cloud as a scanner leaves it, and what is known of the surface that it came from.
struct Scan {
  std::vector<Point> points;       ///< in random order
  std::vector<Point> sensors;      ///< where each was seen from; empty if that is not known
  std::optional<Point> direction;  ///< in which a far sensor looked at all
  double size = 0;                 ///< the longest side of what was scanned

  /// The truth, flat lids in all openings; one of the two at most.
  std::optional<double> volume, area;

  // What a right mesh has.
  double tolerance = INFINITY;  ///< how far its volume or area may be off, as a share of the truth
  bool closed = false;
  bool one_piece = false;
  bool genus_zero = false;
  double longest_edge = INFINITY;  ///< in sizes, at most
  double main_share = 0;           ///< of the area, in the largest component, at least
  std::vector<Point> needed;       ///< of the points; so many of them are vertices, at least:
  std::size_t least_needed = 0;
  double least_used = 0;  ///< share of the points that are vertices
  int most_borders = -1;  ///< loops of edges with one face; negative: any number
  /// Of the area, the share that shows its front to what saw it. For surfaces that may be open: the outside
  /// of a solid is its front.
  double least_front = 0;

  /// There is no surface to find: right is a warning or a refusal, whatever the mesh.
  bool no_surface = false;
};

/// A kind of scan.
struct ScanKind {
  const char* name;
  const char* description;
  const char* methods = "ours";  ///< of the table, with commas between them
};

/// All kinds, in the order of the table.
std::vector<ScanKind> scan_kinds();

/// The same kind and seed give the same scan. Throws std::invalid_argument for an unknown kind.
Scan make_scan(const std::string& kind, std::uint64_t seed);

}  // namespace filmsticking::bench
