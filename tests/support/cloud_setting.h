// SPDX-License-Identifier: GPL-3.0-or-later
// A cloud made into sites, with what the upper layers of the core are given besides.
#pragma once

#include <utility>
#include <vector>

#include "geometry/monitor.h"
#include "points/site_geometry.h"
#include "points/site_set.h"

namespace filmsticking::test {

struct CloudSetting {
  std::vector<Point> points;
  PointsView view{points};
  Options options;
  SiteSet sites;
  SiteGeometry geometry;
  Report report;
  Execution execution;
  Monitor monitor;

  explicit CloudSetting(std::vector<Point> cloud, Options chosen = {})
      : points(std::move(cloud)),
        options(std::move(chosen)),
        sites(make_site_set(points)),
        geometry(site_geometry(sites.perturbed)),
        monitor(execution, report) {
    report.sites = static_cast<std::int64_t>(sites.size());
  }
};

}  // namespace filmsticking::test
