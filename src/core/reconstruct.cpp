// SPDX-License-Identifier: GPL-3.0-or-later
#include "filmsticking/reconstruct.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <new>
#include <optional>

#include "delaunay/delaunay.h"
#include "geometry/euler.h"
#include "geometry/monitor.h"
#include "geometry/parallel.h"
#include "pipeline.h"
#include "points/outliers.h"
#include "points/site_set.h"
#include "surface/cap_faces.h"
#include "surface/feature_flips.h"
#include "surface/meeting_faces.h"
#include "surface/open_surface.h"
#include "surface/orientation.h"
#include "surface/pinholes.h"
#include "surface/viewpoint.h"

namespace filmsticking {
namespace {

void fail(Result& result, Status status, std::string message) {
  result.status = status;
  result.message = std::move(message);
  result.vertices.clear();
  result.triangles.clear();
  result.gaps.clear();
}

// Memory of the largest moment, in bytes: by the points, the sites and the tetrahedra. Measured, and rounded
// up.
constexpr std::int64_t kBytesPerPoint = 32, kBytesPerSite = 500, kBytesPerTetrahedron = 300;
// Sites on a surface have about this many tetrahedra each, and no sampled surface comes near the next figure;
// below the last none are too many.
constexpr std::int64_t kUsualTetrahedra = 6, kMostTetrahedra = 64, kFewTetrahedra = 1000000;

std::int64_t bytes_for(std::int64_t points, std::int64_t sites, std::int64_t tetrahedra) {
  return kBytesPerPoint * points + kBytesPerSite * sites + kBytesPerTetrahedron * tetrahedra;
}

std::string megabytes(std::int64_t bytes) { return std::to_string((bytes + 999999) / 1000000) + " MB"; }

// Why a triangulation of more than these tetrahedra is not made; nothing if it may be.
std::optional<std::pair<Status, std::string>> refusal(std::int64_t points, std::int64_t sites,
                                                      std::int64_t tetrahedra, std::int64_t max_memory) {
  if (const std::int64_t bytes = bytes_for(points, sites, tetrahedra); max_memory > 0 && bytes > max_memory)
    return std::pair(Status::OutOfMemory, "more than " + megabytes(bytes) +
                                              " of memory would be needed, and " + megabytes(max_memory) +
                                              " are allowed");
  if (tetrahedra >= kFewTetrahedra + kMostTetrahedra * sites)
    return std::pair(Status::TooComplex, std::string(describe(Status::TooComplex)));
  return {};
}

// Empty if the options are fine.
std::string complaint(const Options& o) {
  if (o.virtual_sites < Options::kAdaptiveVirtualSites)
    return "the number of virtual sites must not be negative";
  if (o.max_steps < 1) return "at least one film step is needed";
  if (o.max_rounds < 0) return "the number of rounds must not be negative";
  if (o.threads < 0) return "the number of threads must not be negative";
  if (o.max_memory < 0) return "the memory allowed must not be negative";
  return {};
}

Status check_given_surface(const Options& o) {
  if (method_of(o) != Method::Film || film_start_of(o) != FilmStart::Given) return Status::Ok;
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
void write_result(const Surface& film, const std::vector<float>& gaps, const SiteSet& sites, Result& result) {
  // Sorting by counting: the ids and the least corners are small numbers.
  std::vector<Index> vertex(static_cast<std::size_t>(result.report.points), kNone);
  for (Index s : film.site) vertex[sites.input[s]] = 0;
  for (std::size_t i = 0; i < vertex.size(); ++i)
    if (vertex[i] != kNone) {
      vertex[i] = static_cast<Index>(result.vertices.size());
      result.vertices.push_back(static_cast<std::int32_t>(i));
    }
  std::vector<Corners> turned(film.triangles.size());
  parallel_each(turned.size(), [&](std::size_t t) {
    Corners c = film.triangles[t];
    for (Index& v : c) v = vertex[sites.input[film.site[v]]];
    std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
    turned[t] = c;
  });
  std::vector<Index> offset(result.vertices.size() + 1, 0), order(turned.size());
  for (const Corners& c : turned) ++offset[c[0] + 1];
  for (std::size_t v = 1; v < offset.size(); ++v) offset[v] += offset[v - 1];
  std::vector<Index> fill(offset.begin(), offset.end() - 1);
  for (std::size_t t = 0; t < turned.size(); ++t) order[fill[turned[t][0]]++] = static_cast<Index>(t);
  result.triangles.resize(turned.size());
  result.gaps.resize(turned.size());
  parallel_each(result.vertices.size(), [&](std::size_t v) {
    std::sort(order.begin() + offset[v], order.begin() + offset[v + 1],
              [&](Index a, Index b) { return turned[a] < turned[b]; });
    for (Index k = offset[v]; k < offset[v + 1]; ++k)
      result.triangles[k] = turned[order[k]], result.gaps[k] = gaps[order[k]];
  });
}

// `topology`: that of the film, of which the result is another numbering.
void describe_result(Result& result, const SurfaceTopology& topology) {
  Report& report = result.report;
  const Index vertices = static_cast<Index>(result.vertices.size());
  const ManifoldCheck& check = topology.check;
  report.closed = check.closed;
  report.manifold = check.manifold();
  report.boundary_edges = check.boundary_edges;
  report.interpolated = vertices;
  report.triangles = static_cast<std::int64_t>(result.triangles.size());
  if (!report.manifold) return;
  report.components = topology.components;
  report.boundary_loops = boundary_loops(topology.twin);
  report.genus =
      genus(report.components, euler_characteristic(vertices, report.triangles, report.boundary_edges),
            report.boundary_loops);
}

void run(const PointsView& points, const Options& options, const Execution& execution, Result& result) {
  Report& report = result.report;
  report.points = static_cast<std::int64_t>(points.size());
  const std::string wrong = complaint(options);
  if (!wrong.empty()) return fail(result, Status::InvalidOptions, wrong);
  if (check_given_surface(options) != Status::Ok)
    return fail(result, Status::InvalidGuidingSurface, describe(Status::InvalidGuidingSurface));

  Monitor monitor(execution, report);
  if (const auto no = refusal(report.points, 0, 0, options.max_memory))
    return fail(result, no->first, no->second);
  monitor.enter("sites", 0);
  SiteSet sites = make_site_set(points);
  report.sites = static_cast<std::int64_t>(sites.size());
  report.non_finite = sites.non_finite;
  report.duplicates = sites.duplicates;
  if (sites.size() < 4)
    return fail(result, Status::TooFewPoints,
                "a closed surface needs at least four distinct finite points, here are " +
                    std::to_string(sites.size()));
  if (sites.coplanar(points)) return fail(result, Status::Coplanar, describe(Status::Coplanar));

  if (const auto no =
          refusal(report.points, report.sites, kUsualTetrahedra * report.sites, options.max_memory))
    return fail(result, no->first, no->second);
  TriangulationLimits limits{kFewTetrahedra + kMostTetrahedra * report.sites, monitor.cancel()};
  if (options.max_memory > 0)
    limits.tetrahedra =
        std::min(limits.tetrahedra,
                 (options.max_memory - bytes_for(report.points, report.sites, 0)) / kBytesPerTetrahedron + 1);

  monitor.enter("triangulation", 0.02);
  SiteGeometry geometry = site_geometry(sites.perturbed);
  if (!options.keep_outliers) report.outliers = drop_outliers(sites, points, geometry);
  Pipeline pipeline(points, sites, geometry, options, monitor, report);
  Surface film;
  if (options.open_boundary && method_of(options) == Method::Labelling)
    if (auto visible = pipeline.visible_surface()) film = std::move(visible->surface);
  if (!pipeline.viewpoint()) {
    monitor.enter("triangulation", monitor.share());
    Tetrahedra tetrahedra;
    try {
      tetrahedra = delaunay_tetrahedra(sites.perturbed, limits);
    } catch (const TooManyTetrahedra&) {
      const auto no = refusal(report.points, report.sites, limits.tetrahedra, options.max_memory);
      return fail(result, no->first, no->second);
    }
    film = pipeline.run(std::move(tetrahedra));
  }
  const Vec3* viewpoint = pipeline.viewpoint() ? &*pipeline.viewpoint() : nullptr;
  std::optional<SurfaceTopology> topology;
  const auto orient = [&] {
    topology.emplace(film.triangles, static_cast<Index>(film.positions.size()));
    if (!topology->check.manifold()) return !film.triangles.empty();  // told of below
    // Where sites lie on a plane, perturbed ones could be turned over.
    parallel_each(film.site.size(),
                  [&](std::size_t v) { film.positions[v] = sites.exact(points, film.site[v]); });
    const auto changed = [&](std::int64_t changes) {
      if (changes > 0) topology.emplace(film.triangles, static_cast<Index>(film.positions.size()));
    };
    changed(remove_cap_faces(film, topology->twin));
    if (options.open_boundary && !topology->check.closed) {
      if (!viewpoint) changed(remove_meeting_faces(film, geometry, monitor.cancel()));
      changed(fill_pinholes(film, topology->twin, geometry, viewpoint));
    }
    if (options.sharp_edges) {
      monitor.enter("sharp edges", monitor.share());
      report.flips = flip_to_features(film, topology->twin, monitor.cancel(), viewpoint);
      topology->check =
          check_manifold_with_twins(film.triangles, static_cast<Index>(film.site.size()), topology->twin);
    }
    if (!topology->check.manifold()) return true;
    std::vector<std::int32_t> ids(film.site.size());
    parallel_each(ids.size(), [&](std::size_t v) { ids[v] = sites.input[film.site[v]]; });
    if (options.open_boundary && !viewpoint) face_viewpoint(film, *topology, monitor.cancel());
    return orient_components(film, points.at(ids), *topology);
  };
  bool oriented = orient();
  // A closed film may be flat, by less than the points are perturbed: few points, mostly on a plane.
  if (!oriented && !options.open_boundary) film = pipeline.around_one_tetrahedron(), oriented = orient();
  if (!oriented) return fail(result, Status::NoSurface, describe(Status::NoSurface));
  monitor.enter("result", 0.97);
  write_result(film, face_gaps(film, geometry), sites, result);
  describe_result(result, *topology);
  if (result.vertices.size() != film.site.size() || !report.manifold ||
      !(report.closed || options.open_boundary))
    return fail(result, Status::InternalError, "the result is not a closed manifold");
  monitor.progress(1);
  result.status = Status::Ok;
}

}  // namespace

Options Options::paper() {
  Options options;
  options.method = Method::Film;
  options.field = FieldMethod::Poisson;
  options.virtual_sites = 1000;
  options.insert_leftover = false;
  options.sharp_edges = false;
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
    case Status::TooComplex:
      return "the points' Delaunay triangulation is far larger than that of any surface, as of points on two "
             "curves";
    case Status::Cancelled:
      return "the reconstruction was cancelled";
    case Status::OutOfMemory:
      return "not enough memory";
    case Status::InternalError:
      return "an internal check failed";
  }
  return "unknown status";
}

Result reconstruct(const PointsView& points, const Options& options, const Execution& execution) noexcept {
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
  } catch (const CallbackThrew& threw) {
    failed(Status::Cancelled, threw.what.c_str());
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
