// SPDX-License-Identifier: GPL-3.0-or-later
#include "points/site_viewpoints.h"

#include "geometry/parallel.h"

namespace filmsticking {
namespace {

constexpr double kFarEnough = 100;

}  // namespace

std::vector<Vec3> site_viewpoints(const SiteSet& sites, const Options& options) {
  std::vector<Vec3> places;
  if (options.viewpoints) {
    places.resize(sites.size());
    parallel_each(places.size(), [&](std::size_t s) {
      places[s] = sites.to_unit((*options.viewpoints)[static_cast<std::size_t>(sites.input[s])]);
    });
  } else if (options.view_direction) {
    const Point& d = *options.view_direction;
    const Vec3 back = -kFarEnough * sites.turn(Vec3(d[0], d[1], d[2]).stableNormalized());
    for (const Vec3& site : sites.perturbed) places.push_back(site + back);
  } else if (options.viewpoint) {
    places.assign(sites.size(), sites.to_unit(*options.viewpoint));
  }
  return places;
}

}  // namespace filmsticking
