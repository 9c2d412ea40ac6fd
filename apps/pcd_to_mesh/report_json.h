// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "filmsticking/reconstruct.h"
#include "filters/ground_plane.h"

namespace filmsticking::app {

/// The parts of a report that the result does not hold.
struct RunFacts {
  std::string input;
  std::string output;
  std::vector<std::string> notes;              ///< how the input was read: sentences
  std::int64_t read = 0;                       ///< points in the input
  std::optional<filters::GroundPlane> ground;  ///< of --ground
  std::int64_t on_ground = 0;                  ///< points left out with it
  std::int64_t added = 0;                      ///< points added on it and below outlines: the last ones
  double seconds = 0;                          ///< wall time with reading and writing
  std::int64_t peak_memory_bytes = 0;
};

/// The report of --report. With --ground, it has ground: the plane as A, B, C, D, on_ground and added. Its
/// other fields:
///   input, output, status, message, warning: strings; message is empty when status is "Ok", warning unless
///   the result is doubtful (Report::warning)
///   notes: how the input was read, a list of sentences
///   read: points in the input; points: those that the filters left
///   sites, non_finite, duplicates, outliers, inserted, flips, rounds: as in Report
///   interpolated, interpolated_share: of the sites, 0 to 1
///   vertices, triangles, components, genus, boundary_edges, boundary_loops, closed, manifold: the mesh
///   holes: a list of length, diameter, area, centre, normal, edges, closed, as in Hole
///   steps: a list of round, attracted, virtual_left, weighted, held, seconds
///   rooms: a list of room, seconds
///   reconstruction_seconds, seconds (with reading and writing), peak_memory_bytes
std::string report_json(const Result& result, const RunFacts& facts);

/// The name of a status, as in the code.
const char* status_name(Status status);

}  // namespace filmsticking::app
