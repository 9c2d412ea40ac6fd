// SPDX-License-Identifier: GPL-3.0-or-later
#include "write_result.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "failure.h"
#include "geometry/euler.h"
#include "geometry/parallel.h"
#include "surface/open_surface.h"

namespace filmsticking {
namespace {

// Triangles turned to their least corner, in the result's vertices, which it fills.
std::vector<Corners> number_vertices(const Surface& surface, const SiteSet& sites, Result& result) {
  std::vector<Index> vertex(static_cast<std::size_t>(result.report.points), kNone);
  for (Index s : surface.site) vertex[sites.input[s]] = 0;
  for (std::size_t i = 0; i < vertex.size(); ++i)
    if (vertex[i] != kNone) {
      vertex[i] = static_cast<Index>(result.vertices.size());
      result.vertices.push_back(static_cast<std::int32_t>(i));
    }
  std::vector<Corners> turned(surface.triangles.size());
  parallel_each(turned.size(), [&](std::size_t t) {
    Corners c = surface.triangles[t];
    for (Index& v : c) v = vertex[sites.input[surface.site[v]]];
    std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
    turned[t] = c;
  });
  return turned;
}

// A counting sort by the least corner, then a sort of the few triangles that share one.
void sort_triangles(const std::vector<Corners>& turned, const std::vector<float>& gaps,
                    const std::vector<float>& stability, Result& result) {
  std::vector<Index> offset(result.vertices.size() + 1, 0), order(turned.size());
  for (const Corners& c : turned) ++offset[c[0] + 1];
  for (std::size_t v = 1; v < offset.size(); ++v) offset[v] += offset[v - 1];
  std::vector<Index> fill(offset.begin(), offset.end() - 1);
  for (std::size_t t = 0; t < turned.size(); ++t) order[fill[turned[t][0]]++] = static_cast<Index>(t);
  result.triangles.resize(turned.size());
  result.gaps.resize(turned.size());
  result.stability.resize(stability.size());
  parallel_each(result.vertices.size(), [&](std::size_t v) {
    std::sort(order.begin() + offset[v], order.begin() + offset[v + 1],
              [&](Index a, Index b) { return turned[a] < turned[b]; });
    for (Index k = offset[v]; k < offset[v + 1]; ++k) {
      result.triangles[k] = turned[order[k]], result.gaps[k] = gaps[order[k]];
      if (!stability.empty()) result.stability[k] = stability[order[k]];
    }
  });
}

// [triangle] the least of its corners' values; empty as those.
std::vector<float> least_of_corners(const Surface& surface, const std::vector<float>& of_site) {
  std::vector<float> least(of_site.empty() ? 0 : surface.triangles.size(), 1);
  parallel_each(least.size(), [&](std::size_t t) {
    for (const Index v : surface.triangles[t]) least[t] = std::min(least[t], of_site[surface.site[v]]);
  });
  return least;
}

// The result is another numbering of the surface, so its topology is the surface's.
void describe_result(const SurfaceTopology& topology, Result& result) {
  Report& report = result.report;
  const ManifoldCheck& check = topology.check;
  report.closed = check.closed;
  report.manifold = check.manifold();
  report.boundary_edges = check.boundary_edges;
  report.interpolated = static_cast<std::int64_t>(result.vertices.size());
  report.triangles = static_cast<std::int64_t>(result.triangles.size());
  if (!result.stability.empty())
    report.stability = std::accumulate(result.stability.begin(), result.stability.end(), 0.0) /
                       static_cast<double>(result.stability.size());
  if (!report.manifold) return;
  report.components = topology.components;
  report.boundary_loops = boundary_loops(topology.twin);
  report.genus = genus(report.components,
                       euler_characteristic(report.interpolated, report.triangles, report.boundary_edges),
                       report.boundary_loops);
}

// In the caller's unit; the widest first.
std::vector<Hole> holes_of(const FinishedSurface& finished, const SiteSet& sites) {
  std::vector<Hole> holes;
  for (const Opening& opening : finished.openings) {
    std::vector<Vec3> corners;
    for (const Index v : opening.rim) corners.push_back(finished.surface.positions[v]);
    Hole hole = measure_rim(corners);
    hole.length *= sites.side, hole.diameter *= sites.side, hole.area *= sites.side * sites.side;
    hole.centre = sites.to_input({hole.centre[0], hole.centre[1], hole.centre[2]});
    const Vec3 normal = sites.turn.back({hole.normal[0], hole.normal[1], hole.normal[2]});
    hole.normal = {normal.x(), normal.y(), normal.z()};
    hole.closed = opening.closed;
    holes.push_back(hole);
  }
  std::stable_sort(holes.begin(), holes.end(),
                   [](const Hole& a, const Hole& b) { return a.diameter > b.diameter; });
  return holes;
}

}  // namespace

void write_result(const FinishedSurface& finished, const SiteSet& sites, const SiteGeometry& geometry,
                  const std::vector<float>& stability, bool may_be_open, Result& result) {
  const std::vector<Corners> turned = number_vertices(finished.surface, sites, result);
  sort_triangles(turned, face_gaps(finished.surface, geometry), least_of_corners(finished.surface, stability),
                 result);
  describe_result(finished.topology, result);
  result.report.holes = holes_of(finished, sites);
  const Report& report = result.report;
  if (result.vertices.size() != finished.surface.site.size() || !report.manifold ||
      !(report.closed || may_be_open))
    throw Failure(Status::InternalError, "the result is not a closed manifold");
}

}  // namespace filmsticking
