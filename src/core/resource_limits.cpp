// SPDX-License-Identifier: GPL-3.0-or-later
#include "resource_limits.h"

#include <algorithm>
#include <string>

#include "failure.h"

namespace filmsticking {
namespace {

// Peak memory in bytes. Measured, and rounded up.
constexpr std::int64_t kBytesPerPoint = 32, kBytesPerSite = 500, kBytesPerTetrahedron = 300;
// Tetrahedra per site of points on a surface: about.
constexpr std::int64_t kUsualTetrahedra = 6;
// Tetrahedra per site that no sampled surface reaches. More: refuse.
constexpr std::int64_t kMostTetrahedra = 64;
// Tetrahedra that are never too many.
constexpr std::int64_t kFewTetrahedra = 1000000;

std::int64_t bytes_for(std::int64_t points, std::int64_t sites, std::int64_t tetrahedra) {
  return kBytesPerPoint * points + kBytesPerSite * sites + kBytesPerTetrahedron * tetrahedra;
}

std::string megabytes(std::int64_t bytes) { return std::to_string((bytes + 999999) / 1000000) + " MB"; }

void check_memory(std::int64_t bytes, const Options& options) {
  if (options.max_memory > 0 && bytes > options.max_memory)
    throw Failure(Status::OutOfMemory, "more than " + megabytes(bytes) + " of memory would be needed, and " +
                                           megabytes(options.max_memory) + " are allowed");
}

}  // namespace

void check_memory_for_points(const Report& report, const Options& options) {
  check_memory(bytes_for(report.points, 0, 0), options);
}

TriangulationLimits triangulation_limits(const Report& report, const Options& options, const Cancel& cancel) {
  check_memory(bytes_for(report.points, report.sites, kUsualTetrahedra * report.sites), options);
  TriangulationLimits limits{kFewTetrahedra + kMostTetrahedra * report.sites, cancel};
  if (options.max_memory > 0)
    limits.tetrahedra =
        std::min(limits.tetrahedra,
                 (options.max_memory - bytes_for(report.points, report.sites, 0)) / kBytesPerTetrahedron + 1);
  return limits;
}

void refuse_triangulation(const TriangulationLimits& limits, const Report& report, const Options& options) {
  check_memory(bytes_for(report.points, report.sites, limits.tetrahedra), options);
  throw Failure(Status::TooComplex);
}

}  // namespace filmsticking
