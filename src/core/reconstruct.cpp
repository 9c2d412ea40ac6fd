// SPDX-License-Identifier: GPL-3.0-or-later
#include "filmsticking/reconstruct.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <new>
#include <numeric>

#include "monitor.h"
#include "open_surface.h"
#include "orientation.h"
#include "outliers.h"
#include "pipeline.h"
#include "site_set.h"
#include "triangle_adjacency.h"

namespace filmsticking {
namespace {

void fail(Result& result, Status status, std::string message) {
  result.status = status;
  result.message = std::move(message);
  result.vertices.clear();
  result.triangles.clear();
  result.gaps.clear();
}

// Empty if the options are fine.
std::string complaint(const Options& o) {
  if (o.virtual_sites < Options::kAdaptiveVirtualSites)
    return "the number of virtual sites must not be negative";
  if (o.max_steps < 1) return "at least one film step is needed";
  if (o.max_rounds < 0) return "the number of rounds must not be negative";
  if (o.threads < 0) return "the number of threads must not be negative";
  return {};
}

Status check_given_surface(const Options& o) {
  if (o.initial_surface != InitialSurface::Given) return Status::Ok;
  if (!o.guiding_surface) return Status::InvalidGuidingSurface;
  for (const Point& p : o.guiding_surface->positions)
    for (double x : p)
      if (!std::isfinite(x)) return Status::InvalidGuidingSurface;
  const std::vector<Corners> triangles(o.guiding_surface->triangles.begin(),
                                       o.guiding_surface->triangles.end());
  const ManifoldCheck check =
      check_manifold(triangles, static_cast<Index>(o.guiding_surface->positions.size()));
  return check.ok() ? Status::Ok : Status::InvalidGuidingSurface;
}

// Sites to input ids in rising order; triangles turned to their least corner and sorted.
void write_result(const GuidingSurface& film, const std::vector<float>& gaps, const SiteSet& sites,
                  Result& result) {
  std::vector<Index> order(film.site.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](Index a, Index b) { return sites.input[film.site[a]] < sites.input[film.site[b]]; });
  std::vector<Index> vertex(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    vertex[order[k]] = static_cast<Index>(k);
    result.vertices.push_back(sites.input[film.site[order[k]]]);
  }
  std::vector<std::pair<Triangle, float>> faces;
  faces.reserve(film.triangles.size());
  for (std::size_t t = 0; t < film.triangles.size(); ++t) {
    Corners c = film.triangles[t];
    for (Index& v : c) v = vertex[v];
    std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
    faces.emplace_back(c, gaps[t]);
  }
  std::sort(faces.begin(), faces.end());
  for (const auto& [triangle, gap] : faces) result.triangles.push_back(triangle), result.gaps.push_back(gap);
}

// The number of closed loops of edges with one face. Of a manifold, which has one loop end at a vertex.
std::int64_t boundary_loops(const std::vector<Index>& twin) {
  std::vector<char> seen(twin.size(), 0);
  std::int64_t loops = 0;
  for (Index h = 0; h < static_cast<Index>(twin.size()); ++h) {
    if (twin[h] != kNone || seen[h]) continue;
    ++loops;
    for (Index g = h; !seen[g];) {
      seen[g] = 1;
      for (g = next_in_face(g); twin[g] != kNone;) g = next_in_face(twin[g]);
    }
  }
  return loops;
}

void describe_result(Result& result) {
  Report& report = result.report;
  const Index vertices = static_cast<Index>(result.vertices.size());
  const ManifoldCheck check = check_manifold(result.triangles, vertices);
  report.closed = check.closed;
  report.manifold = check.manifold();
  report.boundary_edges = check.boundary_edges;
  report.interpolated = vertices;
  report.triangles = static_cast<std::int64_t>(result.triangles.size());
  if (!report.manifold) return;
  std::vector<Index> component;
  const std::vector<Index> twin = half_edge_twins(result.triangles, vertices);
  report.components = connected_components(twin, component);
  report.boundary_loops = boundary_loops(twin);
  const std::int64_t edges = (3 * report.triangles + report.boundary_edges) / 2;
  const std::int64_t euler = vertices - edges + report.triangles;
  report.genus = (2 * report.components - euler - report.boundary_loops) / 2;
}

void run(const std::vector<Point>& points, const Options& options, const Execution& execution,
         Result& result) {
  Report& report = result.report;
  report.points = static_cast<std::int64_t>(points.size());
  const std::string wrong = complaint(options);
  if (!wrong.empty()) return fail(result, Status::InvalidOptions, wrong);
  if (check_given_surface(options) != Status::Ok)
    return fail(result, Status::InvalidGuidingSurface, describe(Status::InvalidGuidingSurface));

  Monitor monitor(execution, report);
  monitor.enter("sites", 0);
  SiteSet sites = make_site_set(points);
  report.sites = static_cast<std::int64_t>(sites.size());
  report.non_finite = sites.non_finite;
  report.duplicates = sites.duplicates;
  if (sites.size() < 4)
    return fail(result, Status::TooFewPoints,
                "a closed surface needs at least four distinct finite points, here are " +
                    std::to_string(sites.size()));
  if (sites.coplanar()) return fail(result, Status::Coplanar, describe(Status::Coplanar));

  monitor.enter("outliers", 0.01);
  SiteGeometry geometry = site_geometry(sites.perturbed);
  if (!options.keep_outliers) report.outliers = drop_outliers(sites, geometry);

  GuidingSurface film = Pipeline(sites, geometry, options, monitor, report).run();
  if (film.triangles.empty()) return fail(result, Status::NoSurface, describe(Status::NoSurface));
  monitor.enter("result", 0.97);
  std::vector<Point> places;
  for (const Index site : film.site) places.push_back(points[static_cast<std::size_t>(sites.input[site])]);
  // It may be flat, by less than the points are perturbed.
  if (!options.open_boundary && !orient_components(film, places))
    return fail(result, Status::NoSurface, describe(Status::NoSurface));
  write_result(film, face_gaps(film, geometry), sites, result);
  describe_result(result);
  if (!report.manifold || !(report.closed || options.open_boundary))
    return fail(result, Status::InternalError, "the result is not a closed manifold");
  monitor.progress(1);
  result.status = Status::Ok;
}

}  // namespace

Options Options::paper() {
  Options options;
  options.initial_surface = InitialSurface::Sphere;
  options.field = FieldMethod::Poisson;
  options.virtual_sites = 1000;
  options.insert_leftover = false;
  options.max_rounds = 1;
  return options;
}

const char* describe(Status status) noexcept {
  switch (status) {
    case Status::Ok:
      return "a closed surface was made";
    case Status::TooFewPoints:
      return "a closed surface needs at least four distinct finite points";
    case Status::Coplanar:
      return "all points lie on one plane, so they enclose no volume";
    case Status::InvalidInput:
      return "the input cloud or its indices cannot be used";
    case Status::InvalidOptions:
      return "an option is out of its range";
    case Status::InvalidGuidingSurface:
      return "the guiding surface given is not a closed oriented 2-manifold";
    case Status::NoSurface:
      return "no closed surface through the points was found";
    case Status::Cancelled:
      return "the reconstruction was cancelled";
    case Status::OutOfMemory:
      return "not enough memory";
    case Status::InternalError:
      return "an internal check failed";
  }
  return "unknown status";
}

Result reconstruct(const std::vector<Point>& points, const Options& options,
                   const Execution& execution) noexcept {
  const auto start = std::chrono::steady_clock::now();
  Result result;
  const auto failed = [&](Status status, const char* message) {
    try {
      fail(result, status, message);
    } catch (...) {  // a message is a kindness; the status says enough
      fail(result, status, {});
    }
  };
  try {
    tbb::task_arena arena(options.threads > 0 ? options.threads : tbb::task_arena::automatic);
    arena.execute([&] { run(points, options, execution, result); });
  } catch (const Cancelled&) {
    failed(Status::Cancelled, describe(Status::Cancelled));
  } catch (const std::bad_alloc&) {
    failed(Status::OutOfMemory, describe(Status::OutOfMemory));
  } catch (const std::exception& e) {
    failed(Status::InternalError, e.what());
  } catch (...) {
    failed(Status::InternalError, describe(Status::InternalError));
  }
  result.report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace filmsticking
