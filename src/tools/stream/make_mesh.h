// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/PolygonMesh.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>

#include "filmsticking/options.h"
#include "filmsticking/report.h"
#include "filmsticking/status.h"
#include "filters/filter_options.h"

namespace filmsticking::stream {

/// A cloud to reconstruct, for make_mesh().
struct MeshJob {
  pcl::PCLPointCloud2 cloud;
  filters::FilterOptions filters;  ///< run on the cloud first
  /// A viewpoint or a direction of view that is given here wins over those of the points, which are in the
  /// fields that io::viewpoints_of() reads. Without either, none is tried.
  Options options;
};

/// How a MeshJob ended.
struct Outcome {
  Status status = Status::InternalError;
  std::string message;  ///< one sentence, without a full stop, about a failure
  pcl::PolygonMesh
      mesh;  ///< vertices with the fields of the cloud but io::kStationFields; empty after a failure
  std::int64_t points = 0;  ///< of the cloud, before the filters
  double seconds = 0;       ///< wall time, filters included
  Report report;
};

/// Called with the share done, 0 to 1 and never falling, and the stage at work. Must not throw.
using Progress = std::function<void(double share, const char* stage)>;

/// Filters a cloud and reconstructs it by pcl::FilmstickingPP. Ends soon, with Status::Cancelled, once
/// `cancel` is true; it may be null. Throws nothing: failures are statuses.
Outcome make_mesh(MeshJob job, const std::atomic<bool>* cancel = nullptr,
                  const Progress& progress = nullptr) noexcept;

}  // namespace filmsticking::stream
