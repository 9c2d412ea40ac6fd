// SPDX-License-Identifier: GPL-3.0-or-later
// The entry of the library: points in, closed interpolating mesh out.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "execution.h"
#include "export.h"
#include "options.h"
#include "report.h"
#include "status.h"
#include "types.h"

namespace filmsticking {

/// The outcome of reconstruct().
struct Result {
  Status status = Status::InternalError;  ///< how it ended
  std::string message;                    ///< one sentence on a failure; empty if `status` is Ok
  std::vector<std::int32_t> vertices;     ///< vertex k is input point vertices[k]; strictly increasing
  std::vector<Triangle> triangles;        ///< indices into `vertices`, counter-clockwise seen from outside
  /// [triangle]: the gap that it bridges: the diameter of its smallest enclosing circle, in spacings of the
  /// points there. Dimensionless: about 1.5 on an evenly sampled surface, large where no data support a face.
  std::vector<float> gaps;
  /// [triangle]: from 0 to 1, how much of the surface around it one more film step would keep: the least of
  /// its corners, each the share of its faces, before sharp edges, that stay. Low where the samples alone do
  /// not tell inside from outside: thin plates, chance gaps, noise. Empty without Options::stability, for a
  /// depth image's open surface, and for the last resort of a flat cloud, one grown tetrahedron.
  std::vector<float> stability;
  Report report;  ///< what was done, up to a failure
};

/// Reconstructs a surface through `points` by Filmsticking++ (Wang et al., arXiv 2602.11433).
///
/// Guarantees, for any input:
///  1. Closed: every edge of the result has exactly two faces.
///  2. Manifold: the faces around every vertex form one ring; no vertex, edge or face is repeated.
///  3. Oriented: neighbouring faces agree, and every outermost component encloses positive volume.
///  4. Interpolating: vertices are input points, given by index; no position is computed.
///  5. Deterministic: the same points give the same result, for any number of threads.
///  6. With Options::open_boundary or max_hole, instead of 1: every edge has one or two faces; instead of 2:
///  the faces
///     around every vertex form one ring or one fan.
///  7. A failure is a status and a sentence with an empty mesh; nothing is thrown.
///
/// `points`: any number, in any order and unit. NaN, infinite and repeated points are skipped. They are read
/// in place; the library makes one copy, scaled to a unit box.
///
/// Memory: about 2 KB per point on a surface; in general 300 bytes per Delaunay tetrahedron. Surfaces have 6
/// to 20 tetrahedra per point. Points on two curves can have the square of their number: a cloud with more
/// than a million tetrahedra and more than 64 per point is refused (Status::TooComplex).
FILMSTICKING_EXPORT Result reconstruct(const PointsView& points, const Options& options = {},
                                       const Execution& execution = {}) noexcept;
/// The same for a vector, so that points in braces compile.
inline Result reconstruct(const std::vector<Point>& points, const Options& options = {},
                          const Execution& execution = {}) noexcept {
  return reconstruct(PointsView(points), options, execution);
}

}  // namespace filmsticking
