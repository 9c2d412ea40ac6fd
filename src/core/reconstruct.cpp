// SPDX-License-Identifier: GPL-3.0-or-later
#include "filmsticking/reconstruct.h"

#include <tbb/task_arena.h>

#include <chrono>
#include <exception>
#include <new>
#include <optional>
#include <string>
#include <utility>

#include "check_options.h"
#include "delaunay/delaunay.h"
#include "failure.h"
#include "geometry/monitor.h"
#include "pipeline.h"
#include "points/even_units.h"
#include "points/filling.h"
#include "points/outliers.h"
#include "points/site_set.h"
#include "resource_limits.h"
#include "surface/finish.h"
#include "write_result.h"

namespace filmsticking {
namespace {

SiteSet sites_of(const PointsView& points, const Options& options, Report& report) {
  SiteSet sites = make_site_set(points, options.keep_outliers);
  // What is left may enclose no volume, as a plane under one far point.
  if (sites.absurd > 0 && (sites.size() < 4 || sites.coplanar(points))) sites = make_site_set(points, true);
  report.outliers = sites.absurd;
  report.sites = static_cast<std::int64_t>(sites.size()) + sites.absurd;
  report.non_finite = sites.non_finite;
  report.duplicates = sites.duplicates;
  if (sites.size() < 4)
    throw Failure(Status::TooFewPoints,
                  "a closed surface needs at least four distinct finite points, here are " +
                      std::to_string(sites.size()));
  if (sites.coplanar(points)) throw Failure(Status::Coplanar);
  return sites;
}

Tetrahedra triangulation_of(const SiteSet& sites, const TriangulationLimits& limits, const Report& report,
                            const Options& options) {
  try {
    return delaunay_tetrahedra(sites.perturbed, limits);
  } catch (const TooManyTetrahedra&) {
    refuse_triangulation(limits, report, options);
  }
}

// Every hole is to be closed: then the result is the closed one.
bool closes_all(const Options& options, const SiteSet& sites) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : sites.perturbed) box.extend(p);
  return options.max_hole >= sites.side * box.diagonal().norm();
}

// Runs all stages in order. Throws Failure, Cancelled or CallbackThrew.
void run(const PointsView& points, Options options, const Execution& execution, Result& result) {
  Report& report = result.report;
  report.points = static_cast<std::int64_t>(points.size());
  check_options(options, points.size());
  check_memory_for_points(report, options);
  Monitor monitor(execution, report);

  monitor.enter("sites", 0);
  SiteSet sites = sites_of(points, options, report);
  if (closes_all(options, sites)) options.max_hole = 0, options.open_boundary = false;
  const TriangulationLimits limits = triangulation_limits(report, options, monitor.cancel());

  monitor.enter("triangulation", 0.02);
  SiteGeometry geometry = site_geometry(sites.perturbed);
  if (!options.keep_outliers) report.outliers += drop_outliers(sites, points, geometry);
  if (fills_volume(sites.perturbed, geometry))
    report.warning = "the points fill a volume, as nodes of finite elements do; leave out those inside it";

  // An open depth image needs no tetrahedra.
  Pipeline pipeline(points, sites, geometry, options, monitor, report);
  std::optional<FoundSurface> found;
  const bool may_open = may_be_open(options);
  if (may_open && method_of(options) == Method::Labelling) found = pipeline.visible_surface();
  if (!found) {
    monitor.enter("triangulation", monitor.share());
    found = pipeline.run(triangulation_of(sites, limits, report, options));
  }

  const FinishOptions finish_options{
      may_open, options.sharp_edges, found->viewpoint ? &*found->viewpoint : nullptr,
      found->viewpoints.empty() ? nullptr : &found->viewpoints, options.max_hole / sites.side};
  FinishedSurface finished =
      finish(std::move(found->surface), points, sites, geometry, finish_options, monitor);
  // Few points, mostly on a plane: a closed surface may be flatter than the perturbation.
  if (!finished.usable && !may_open) {
    found->stability.clear();
    finished = finish(pipeline.around_one_tetrahedron(), points, sites, geometry, finish_options, monitor);
  }
  report.flips = finished.flips;
  if (!finished.usable) throw Failure(Status::NoSurface);

  monitor.enter("result", 0.97);
  write_result(finished, sites, geometry, found->stability, may_open, result);
  if (method_of(options) == Method::Labelling &&
      2 * report.interpolated < static_cast<std::int64_t>(sites.size()))
    throw Failure(Status::NoSurface,
                  "the best surface that was found goes through only " + std::to_string(report.interpolated) +
                      " of " + std::to_string(sites.size()) + " points; sample the surface more evenly");
  monitor.progress(1);
  result.status = Status::Ok;
}

// A map's heights may have another unit than its places.
void run_in_even_units(const PointsView& points, const Options& options, const Execution& execution,
                       Result& result) {
  std::vector<Point> even;
  if (options.view_direction) {
    check_options(options, points.size());
    const Point& d = *options.view_direction;
    even = in_even_units(points, Vec3(d[0], d[1], d[2]));
  }
  run(even.empty() ? points : PointsView(even), options, execution, result);
  if (!even.empty() && result.report.warning.empty())
    result.report.warning =
        "heights are taken for another unit than places on the map, as metres beside degrees; scale them if "
        "they are not";
}

void fail(Result& result, Status status, std::string message) {
  result.status = status;
  result.message = std::move(message);
  result.vertices.clear();
  result.triangles.clear();
  result.gaps.clear();
  result.stability.clear();
}

}  // namespace

Result reconstruct(const PointsView& points, const Options& options, const Execution& execution) noexcept {
  const auto start = std::chrono::steady_clock::now();
  Result result;
  const auto failed = [&](Status status, const char* message) {
    try {
      fail(result, status, message);
    } catch (...) {  // No memory for the message: the status says enough.
      fail(result, status, {});
    }
  };
  try {
    tbb::task_arena arena(options.threads > 0 ? options.threads : tbb::task_arena::automatic);
    arena.execute([&] { run_in_even_units(points, options, execution, result); });
  } catch (const Failure& failure) {
    failed(failure.status, failure.message.c_str());
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
