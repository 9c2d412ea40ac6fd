// SPDX-License-Identifier: GPL-3.0-or-later
#include "promise.h"

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "support/surface_check.h"

namespace filmsticking::test {
namespace {

bool is_finite(const Point& p) { return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]); }

/// Of six times the volume.
int volume_sign(const Mesh& mesh) {
  using Exact = CGAL::Exact_rational;
  const Point& o = mesh.positions[0];
  std::vector<std::array<Exact, 3>> p;
  for (const Point& q : mesh.positions)
    p.push_back({Exact(q[0]) - Exact(o[0]), Exact(q[1]) - Exact(o[1]), Exact(q[2]) - Exact(o[2])});
  Exact sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const auto &a = p[t[0]], &b = p[t[1]], &c = p[t[2]];
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return CGAL::sign(sum);
}

}  // namespace

Mesh mesh_of(const Result& result, const std::vector<Point>& points) {
  Mesh mesh;
  for (const std::int32_t i : result.vertices) mesh.positions.push_back(points.at(i));
  mesh.triangles = result.triangles;
  return mesh;
}

std::string fault_of(const Result& result, const std::vector<Point>& points, bool open) {
  std::set<Point> places;
  std::int64_t non_finite = 0;
  for (const Point& p : points) {
    if (is_finite(p)) {
      places.insert(p);
    } else {
      ++non_finite;
    }
  }
  const auto sites = static_cast<std::int64_t>(places.size()), all = static_cast<std::int64_t>(points.size());
  const Report& report = result.report;
  if (report.points != all || report.non_finite != non_finite || report.sites != sites ||
      report.duplicates != all - non_finite - sites)
    return "the report counts the points wrongly";
  if ((sites < 4) != (result.status == Status::TooFewPoints))
    return "TooFewPoints does not agree with the number of sites";
  switch (result.status) {
    case Status::Ok:
      break;
    case Status::TooFewPoints:
    case Status::Coplanar:
    case Status::NoSurface:
    case Status::TooComplex:  // tetrahedra by the hundred a point
      if (!result.vertices.empty() || !result.triangles.empty()) return "a failure has a mesh";
      return result.message.empty() ? "a failure has no message" : "";
    default:
      return "status " + std::string(describe(result.status)) + ": " + result.message;
  }
  if (!result.message.empty()) return "a success has a message";
  for (const std::int32_t i : result.vertices)
    if (i < 0 || i >= all || !is_finite(points[i])) return "a vertex is none of the finite points";
  const Mesh mesh = mesh_of(result, points);
  const std::string fault = surface_fault(mesh, open);
  if (!fault.empty()) return fault;
  const bool closed = !open || surface_fault(mesh).empty();
  if (report.closed != closed || !report.manifold) return "the report denies what is so";
  if (report.interpolated != static_cast<std::int64_t>(mesh.positions.size()))
    return "the report counts the vertices wrongly";
  if (!closed) return "";
  const int sign = volume_sign(mesh);
  if (sign != 0) return sign > 0 ? "" : "the volume is negative";
  return "the volume is zero";
}

}  // namespace filmsticking::test
