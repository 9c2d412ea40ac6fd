// SPDX-License-Identifier: GPL-3.0-or-later
#include "make_mesh.h"

#include <pcl/point_types.h>
#include <pcl/surface/filmsticking_pp.h>

#include <chrono>
#include <exception>
#include <memory>
#include <new>
#include <utility>
#include <vector>

#include "filters/filter_chain.h"
#include "io/cloud.h"

namespace filmsticking::stream {
namespace {

void run(MeshJob job, const std::atomic<bool>* cancel, const Progress& progress, Outcome& outcome) {
  outcome.points = static_cast<std::int64_t>(io::size_of(job.cloud));
  if (job.filters.any()) job.cloud = filters::filter(job.cloud, job.filters);
  Options& options = job.options;
  if (!options.viewpoint && !options.view_direction && !options.viewpoints)
    if (std::vector<Point> places = io::viewpoints_of(job.cloud); !places.empty())
      options.viewpoints = std::make_shared<const std::vector<Point>>(std::move(places));
  job.cloud = io::without_stations(job.cloud);
  pcl::FilmstickingPP<pcl::PointXYZ> filmsticking;
  filmsticking.useNoViewPoint();  // unless the options have one
  filmsticking.setOptions(job.options);
  filmsticking.setProgressCallback(progress);
  filmsticking.setCancelFlag(cancel);
  filmsticking.setInputBlob(std::make_shared<pcl::PCLPointCloud2>(std::move(job.cloud)));
  filmsticking.reconstruct(outcome.mesh);
  outcome.status = filmsticking.getStatus();
  outcome.message = filmsticking.getStatusMessage();
  outcome.report = filmsticking.getReport();
}

}  // namespace

Outcome make_mesh(MeshJob job, const std::atomic<bool>* cancel, const Progress& progress) noexcept {
  Outcome outcome;
  const auto fail = [&outcome](Status status, const char* message) {
    outcome.status = status;
    outcome.message = message;
    outcome.mesh = {};
  };
  const auto begin = std::chrono::steady_clock::now();
  try {
    run(std::move(job), cancel, progress, outcome);
  } catch (const std::bad_alloc&) {
    fail(Status::OutOfMemory, describe(Status::OutOfMemory));
  } catch (const filters::FilterError& error) {
    fail(Status::InvalidOptions, error.what());
  } catch (const std::exception& error) {
    fail(Status::InternalError, error.what());
  }
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return outcome;
}

}  // namespace filmsticking::stream
