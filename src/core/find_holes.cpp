// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <new>

#include "filmsticking/holes.h"
#include "surface/rims.h"

namespace filmsticking {
namespace {

bool is_valid(const std::vector<Point>& positions, const std::vector<Triangle>& triangles) {
  return std::all_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](std::int32_t v) {
      if (v < 0 || static_cast<std::size_t>(v) >= positions.size()) return false;
      const Point& p = positions[static_cast<std::size_t>(v)];
      return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
    });
  });
}

// Those of one face, against its direction.
std::vector<RimEdge> boundary_edges(const std::vector<Triangle>& triangles) {
  struct Side {
    Index low, high;
    bool falls;  // the face runs from high to low
    bool operator<(const Side& other) const {
      return low != other.low     ? low < other.low
             : high != other.high ? high < other.high
                                  : falls < other.falls;
    }
  };
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (const Triangle& t : triangles)
    for (int k = 0; k < 3; ++k) {
      const Index a = t[k], b = t[(k + 1) % 3];
      if (a != b) sides.push_back({std::min(a, b), std::max(a, b), a > b});
    }
  std::sort(sides.begin(), sides.end());
  std::vector<RimEdge> edges;
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i + 1;
    while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high) ++end;
    if (end == i + 1)
      edges.push_back(sides[i].falls ? RimEdge{sides[i].low, sides[i].high}
                                     : RimEdge{sides[i].high, sides[i].low});
    i = end;
  }
  return edges;
}

}  // namespace

Status find_holes(const std::vector<Point>& positions, const std::vector<Triangle>& triangles,
                  std::vector<Hole>& holes) noexcept {
  holes.clear();
  if (!is_valid(positions, triangles)) return Status::InvalidInput;
  Status status = Status::Ok;
  try {
    for (const Rim& rim : find_rims(boundary_edges(triangles))) {
      std::vector<Vec3> corners;
      for (const Index v : rim) corners.emplace_back(Vec3(positions[static_cast<std::size_t>(v)].data()));
      holes.push_back(measure_rim(corners));
    }
    std::stable_sort(holes.begin(), holes.end(),
                     [](const Hole& a, const Hole& b) { return a.diameter > b.diameter; });
  } catch (const std::bad_alloc&) {
    status = Status::OutOfMemory;
  } catch (...) {
    status = Status::InternalError;
  }
  if (status != Status::Ok) holes.clear();
  return status;
}

}  // namespace filmsticking
