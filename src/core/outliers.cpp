// SPDX-License-Identifier: GPL-3.0-or-later
#include "outliers.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "parallel.h"

namespace filmsticking {
namespace {

// An outlier's spacing in those of its neighbours, and how far off a plane they are, or it from all of them.
constexpr double kLonely = 1.8, kNotFlat = 0.03, kAside = 2;
// The same where the neighbours are outliers as well: in spacings of the median site, and scattered. Of the
// points of evenly sampled surfaces neither takes one; of noise spread evenly through the box around them
// both take three fifths to nine tenths, the rest being near the surface.
constexpr double kFarOff = 4, kScattered = 0.08;

std::vector<char> outliers(const SiteGeometry& geometry) {
  std::vector<double> sorted = geometry.spacing;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  const double typical = *middle;
  std::vector<char> out(geometry.spacing.size());
  parallel_each(out.size(), [&](std::size_t i) {
    const double spacing = geometry.spacing[i], variation = geometry.variation[i];
    out[i] = (variation > kScattered && spacing > kFarOff * typical) ||
             ((variation > kNotFlat || geometry.offset[i] > kAside) &&
              spacing > kLonely * near_spacing(geometry, static_cast<Index>(i)));
  });
  return out;
}

// What was taken out, so that it can be put back without a copy of all.
struct TakenOut {
  struct Site {
    Index before;  // its number among all
    Vec3 perturbed;
    std::int32_t input;
  };
  std::vector<Site> sites;
  std::vector<Index> before;  // of those left
};

void take_out(const std::vector<char>& out, SiteSet& sites, TakenOut& taken) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (out[i]) {
      taken.sites.push_back({taken.before[i], sites.perturbed[i], sites.input[i]});
      continue;
    }
    taken.before[kept] = taken.before[i];
    sites.perturbed[kept] = sites.perturbed[i];
    sites.input[kept++] = sites.input[i];
  }
  taken.before.resize(kept);
  sites.perturbed.resize(kept);
  sites.input.resize(kept);
}

void put_back(const TakenOut& taken, SiteSet& sites) {
  const std::size_t all = sites.size() + taken.sites.size();
  sites.perturbed.resize(all);
  sites.input.resize(all);
  for (std::size_t i = taken.before.size(); i-- > 0;) {  // from behind: none goes to a lower place
    sites.perturbed[taken.before[i]] = sites.perturbed[i];
    sites.input[taken.before[i]] = sites.input[i];
  }
  for (const TakenOut::Site& site : taken.sites) {
    sites.perturbed[site.before] = site.perturbed;
    sites.input[site.before] = site.input;
  }
}

}  // namespace

std::int64_t drop_outliers(SiteSet& sites, const PointsView& points, SiteGeometry& geometry) {
  std::vector<char> out = outliers(geometry);
  if (std::count(out.begin(), out.end(), 1) == 0) return 0;
  const std::size_t all = sites.size();
  TakenOut taken;
  taken.before.resize(all);
  std::iota(taken.before.begin(), taken.before.end(), 0);
  SiteGeometry rest_geometry;
  do {  // ends: every turn leaves fewer
    take_out(out, sites, taken);
    if (3 * sites.size() < 2 * all || sites.size() < 4 || sites.coplanar(points)) {
      put_back(taken, sites);
      return 0;
    }
    rest_geometry = site_geometry(sites.perturbed);
    out = outliers(rest_geometry);
  } while (std::count(out.begin(), out.end(), 1) > 0);
  geometry = std::move(rest_geometry);
  return static_cast<std::int64_t>(taken.sites.size());
}

}  // namespace filmsticking
