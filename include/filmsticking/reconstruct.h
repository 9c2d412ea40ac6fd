// SPDX-License-Identifier: GPL-3.0-or-later
// The library's entry: points in, closed interpolating mesh out.
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
  std::string message;                    ///< one sentence about a failure; empty when `status` is Ok
  std::vector<std::int32_t> vertices;     ///< vertex k is input point vertices[k]; strictly increasing
  std::vector<Triangle> triangles;        ///< indices into `vertices`, counter-clockwise seen from outside
  /// [triangle]: the gap that it bridges, as the diameter of the smallest circle around it in spacings of the
  /// points there; without unit. About 1.5 on an evenly sampled surface; faces across what the points leave
  /// open have large ones.
  std::vector<float> gaps;
  Report report;  ///< what was done, also after a failure
};

/// Reconstructs a surface through `points` by Filmsticking++ (Wang et al., arXiv 2602.11433).
///
/// Guarantees, for any input:
///  1. Closed: every edge of the result has exactly two faces.
///  2. Manifold: the faces around every vertex form one ring; no vertex, edge or face stands twice.
///  3. Oriented: neighbouring faces agree, and every outermost component encloses positive volume.
///  4. Interpolating: vertices are input points, named by index; no position is computed.
///  5. Deterministic: the same points give the same result, for any number of threads.
///  6. With Options::open_boundary, in place of 1: every edge has one or two faces; and in place of 2: the
///     faces around every vertex form one ring or one fan.
///  7. A failure is a status and a sentence with an empty mesh; nothing is thrown.
///
/// `points`: any number, any order, in any unit; NaN, infinite and repeated points are skipped. They are read
/// where they lie; one copy is made, in the unit of the work.
/// Needs about 2 KB of memory a point of a surface, whatever the points 300 bytes a tetrahedron; clouds of
/// more than a million tetrahedra and 64 a point are refused (Status::TooComplex): those of surfaces have 6
/// to 20, those of points on two curves the square of their number.
FILMSTICKING_EXPORT Result reconstruct(const PointsView& points, const Options& options = {},
                                       const Execution& execution = {}) noexcept;
/// The same; so that points in braces are a vector, too.
inline Result reconstruct(const std::vector<Point>& points, const Options& options = {},
                          const Execution& execution = {}) noexcept {
  return reconstruct(PointsView(points), options, execution);
}

}  // namespace filmsticking
