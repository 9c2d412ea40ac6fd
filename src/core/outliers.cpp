// SPDX-License-Identifier: GPL-3.0-or-later
#include "outliers.h"

#include <algorithm>
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

void keep_others(const std::vector<char>& out, SiteSet& sites) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (out[i]) continue;
    sites.positions[kept] = sites.positions[i];
    sites.perturbed[kept] = sites.perturbed[i];
    sites.input[kept++] = sites.input[i];
  }
  sites.positions.resize(kept);
  sites.perturbed.resize(kept);
  sites.input.resize(kept);
}

}  // namespace

std::int64_t drop_outliers(SiteSet& sites, SiteGeometry& geometry) {
  std::vector<char> out = outliers(geometry);
  if (std::count(out.begin(), out.end(), 1) == 0) return 0;
  SiteSet rest = sites;
  SiteGeometry rest_geometry;
  do {  // ends: every turn leaves fewer
    keep_others(out, rest);
    if (3 * rest.size() < 2 * sites.size() || rest.size() < 4 || rest.coplanar()) return 0;
    rest_geometry = site_geometry(rest.perturbed);
    out = outliers(rest_geometry);
  } while (std::count(out.begin(), out.end(), 1) > 0);
  const auto dropped = static_cast<std::int64_t>(sites.size() - rest.size());
  sites = std::move(rest);
  geometry = std::move(rest_geometry);
  return dropped;
}

}  // namespace filmsticking
