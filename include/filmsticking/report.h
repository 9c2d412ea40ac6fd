// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace filmsticking {

/// What one film step did.
struct StepRecord {
  int round = 0;                  ///< 0 before the first field, then the number of fields so far
  std::int64_t attracted = 0;     ///< points on the film after the step
  std::int64_t virtual_left = 0;  ///< virtual sites not yet attracted
  std::int64_t weighted = 0;      ///< points that were given a weight in this step
  /// Surplus regions removed, double edges resolved, thin regions dropped: a film that is on its way meets
  /// cells more than once. Films at rest on an even surface have none; a film whose sites have nearly all
  /// several regions is a double skin, and is given up for another.
  std::int64_t regions_repaired = 0;
  double seconds = 0;  ///< wall time
};

/// Wall time spent in one room of the pipeline.
struct RoomSeconds {
  std::string room;    ///< its name, as a progress callback is told it
  double seconds = 0;  ///< in all visits together
};

/// What a reconstruction did; filled as far as it got, whatever the status.
struct Report {
  std::int64_t points = 0;        ///< points handed in
  std::int64_t sites = 0;         ///< distinct finite points
  std::int64_t non_finite = 0;    ///< points left out because a coordinate is NaN or infinite
  std::int64_t duplicates = 0;    ///< points left out because an equal one came before
  std::int64_t interpolated = 0;  ///< sites that are vertices of the result
  /// Sites left off because no others are near (see Options::keep_outliers): at most a third, where more look
  /// like outliers none is. None of an evenly sampled surface.
  std::int64_t outliers = 0;
  std::int64_t tetrahedra = 0;  ///< of the sites' Delaunay triangulation; 0: an open depth image needs none
  /// Times that a site was brought on to the surface by itself at the end, which the cut or the film had left
  /// off: one in hundreds on clean clouds, many of thin walls and noise.
  std::int64_t inserted = 0;
  /// Edges flipped to lie along sharp edges and bends; Options::sharp_edges.
  std::int64_t flips = 0;
  std::int64_t triangles = 0;       ///< of the result
  std::int64_t components = 0;      ///< connected pieces of the result
  std::int64_t genus = 0;           ///< sum over the components
  std::int64_t boundary_edges = 0;  ///< with one face; none unless an open surface was asked for
  std::int64_t boundary_loops = 0;  ///< closed loops of such edges
  int rounds = 0;                   ///< rounds of field and film
  bool closed = false;              ///< checked on the result: every edge has two faces
  bool manifold = false;            ///< checked on the result: oriented, every vertex has one ring or fan
  std::vector<StepRecord> steps;    ///< one a film step, in order
  std::vector<RoomSeconds> rooms;   ///< in the order in which they were first entered
  double seconds = 0;               ///< wall time of the whole reconstruction
};

}  // namespace filmsticking
