// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "types.h"

namespace filmsticking {

/// What one film step did.
struct StepRecord {
  int round = 0;                  ///< 0 before the first field, then the number of fields so far
  std::int64_t attracted = 0;     ///< points on the film after the step
  std::int64_t virtual_left = 0;  ///< virtual sites not yet attracted
  std::int64_t weighted = 0;      ///< points that were given a weight in this step
  /// Tetrahedra that the step would have taken from the inside, and that memory held: those between
  /// near points of the film.
  std::int64_t held = 0;
  double seconds = 0;  ///< wall time
};

/// Wall time of one stage. The names `room` and `rooms` are those of older versions: callers and the readers
/// of JSON reports use them.
struct RoomSeconds {
  std::string room;    ///< name of the stage, as in Execution::progress
  double seconds = 0;  ///< in all its visits
};

/// A hole of a surface: a loop of edges with one face. Lengths in the points' unit.
struct Hole {
  double length = 0;       ///< of its rim
  double diameter = 0;     ///< of the smallest ball around its rim
  double area = 0;         ///< of its rim, projected along its mean normal
  Point centre{};          ///< mean place of its rim
  std::int64_t edges = 0;  ///< of its rim
  bool closed = false;     ///< it has got a lid (Options::max_hole)
  Point normal{};          ///< of length 1, of a lid that winds as the faces around it; zero if the area is
};

/// What a reconstruction did. After a failure, filled up to it.
struct Report {
  std::int64_t points = 0;        ///< input points
  std::int64_t sites = 0;         ///< distinct finite points
  std::int64_t non_finite = 0;    ///< points skipped: a coordinate is NaN or infinite
  std::int64_t duplicates = 0;    ///< points skipped: equal to an earlier one
  std::int64_t interpolated = 0;  ///< sites that are vertices of the result
  /// Sites left out because no others are near, or absurdly far from all (Options::keep_outliers). Of each
  /// kind at most a third: if more look lonely, none of them is left out. None on an evenly sampled surface.
  std::int64_t outliers = 0;
  std::int64_t tetrahedra =
      0;  ///< of the Delaunay triangulation; 0 for an open depth image, which needs none
  /// Insertions of single sites that the cut or the film had missed: one in hundreds of sites of a clean
  /// cloud, many for thin walls and noise.
  std::int64_t inserted = 0;
  /// Edges flipped along sharp edges and bends (Options::sharp_edges).
  std::int64_t flips = 0;
  std::int64_t triangles = 0;       ///< of the result
  std::int64_t components = 0;      ///< of the result
  std::int64_t genus = 0;           ///< sum over the components
  std::int64_t boundary_edges = 0;  ///< edges with one face; 0 unless may_be_open()
  std::int64_t boundary_loops = 0;  ///< loops of such edges
  std::vector<Hole> holes;          ///< of an open surface, also those that have got a lid; the widest first
  double stability = 0;             ///< mean of Result::stability; 0 where that is empty
  int rounds = 0;                   ///< rounds of field and cut
  bool closed = false;              ///< checked on the result: every edge has two faces
  bool manifold = false;            ///< checked on the result: oriented, every vertex has one ring or fan
  std::vector<StepRecord> steps;    ///< one per film step, in order
  std::vector<RoomSeconds> rooms;   ///< time per stage, in the order of first entry
  double seconds = 0;               ///< wall time of the whole reconstruction
  /// One sentence on an input of which the result is doubtful, for people to read; empty for none. The points
  /// fill a volume, say, and lie not only on its surface.
  std::string warning;
};

}  // namespace filmsticking
