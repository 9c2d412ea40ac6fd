// SPDX-License-Identifier: GPL-3.0-or-later
#include "points/outliers.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "geometry/nearest.h"
#include "geometry/parallel.h"
#include "geometry/quantile.h"

namespace filmsticking {
namespace {

// An outlier has kLonely times its neighbours' spacing. Besides, the neighbours vary off their plane by
// kNotFlat, or the site is kAside off their mean.
constexpr double kLonely = 1.8, kNotFlat = 0.03, kAside = 2;
// Where the neighbours are outliers as well: kFarOff times the median spacing, with neighbours that vary by
// kScattered. Measured: both rules remove none of an evenly sampled surface, and 60 to 90 % of noise spread
// evenly through its box; the rest is near the surface.
constexpr double kFarOff = 4, kScattered = 0.08;

/// Which sites are left. All keep their numbers.
struct Rest {
  std::vector<char> left;
  std::size_t size;
};

std::vector<Index> outliers(const Rest& rest, const SiteGeometry& geometry) {
  std::vector<double> sorted;
  sorted.reserve(rest.size);
  for (std::size_t i = 0; i < rest.left.size(); ++i)
    if (rest.left[i]) sorted.push_back(geometry.spacing[i]);
  const double typical = median(sorted.begin(), sorted.end());
  std::vector<char> out(rest.left.size());
  parallel_each(out.size(), [&](std::size_t i) {
    if (!rest.left[i]) return;
    const double spacing = geometry.spacing[i], variation = geometry.variation[i];
    out[i] = (variation > kScattered && spacing > kFarOff * typical) ||
             ((variation > kNotFlat || geometry.offset[i] > kAside) &&
              spacing > kLonely * near_spacing(geometry, static_cast<Index>(i)));
  });
  std::vector<Index> ids;
  for (std::size_t i = 0; i < out.size(); ++i)
    if (out[i]) ids.push_back(static_cast<Index>(i));
  return ids;
}

// The nearest sites that are left, the site itself first: so many, or all that there are.
std::vector<Index> nearest_left(const PointTree& tree, const Vec3& place, const Rest& rest,
                                std::size_t count) {
  const std::size_t wanted = std::min(count, rest.size);
  for (std::size_t asked = 2 * wanted;; asked *= 2) {  // ends: at the latest when it asks for all
    std::vector<Index> near = tree.nearest(place, asked);
    near.erase(std::remove_if(near.begin(), near.end(), [&](Index i) { return !rest.left[i]; }), near.end());
    if (near.size() < wanted) continue;
    near.resize(wanted);
    return near;
  }
}

// Removes sites, and updates the geometry of sites that had one of them among their neighbours.
void take_out(const std::vector<Index>& out, const std::vector<Vec3>& places, const PointTree& tree,
              Rest& rest, SiteGeometry& geometry) {
  const bool all_near = rest.size <= kNeighbours + 1;  // all are neighbours of each other
  std::vector<Vec3> gone;
  for (const Index i : out) rest.left[i] = 0, gone.push_back(places[i]);
  rest.size -= out.size();
  const PointTree gone_tree(gone);
  parallel_each(places.size(), [&](std::size_t i) {
    if (!rest.left[i]) return;
    double distance2 = 0;
    gone_tree.nearest(places[i], &distance2);
    const double radius = geometry.radius[i] * (1 + 1e-9);
    if (!all_near && distance2 > radius * radius) return;
    describe_site(geometry, places, static_cast<Index>(i),
                  [&](std::size_t count) { return nearest_left(tree, places[i], rest, count); });
  });
}

// Renumbers the sites that are left.
void close_ranks(const Rest& rest, SiteSet& sites, SiteGeometry& geometry) {
  std::vector<Index> number(rest.left.size(), kNone);
  Index kept = 0;
  for (std::size_t i = 0; i < number.size(); ++i)
    if (rest.left[i]) number[i] = kept++;
  const auto close = [&](auto& list) {
    for (std::size_t i = 0; i < number.size(); ++i)
      if (number[i] != kNone) list[number[i]] = list[i];
    list.resize(kept);
  };
  close(sites.perturbed), close(sites.input);
  close(geometry.spacing), close(geometry.radius), close(geometry.near), close(geometry.normal),
      close(geometry.variation);
  close(geometry.offset);
  for (auto& near : geometry.near)
    for (Index& i : near)
      if (i != kNone) i = number[i];
}

}  // namespace

std::int64_t drop_outliers(SiteSet& sites, const PointsView& points, SiteGeometry& geometry) {
  const std::size_t all = sites.size();
  Rest rest{std::vector<char>(all, 1), all};
  std::vector<Index> out = outliers(rest, geometry);
  if (out.empty()) return 0;
  SiteGeometry of_rest = geometry;
  const PointTree tree(sites.perturbed);
  for (; !out.empty(); out = outliers(rest, of_rest)) {  // ends: every pass removes sites
    if (3 * (rest.size - out.size()) < 2 * all || rest.size - out.size() < 4) return 0;
    take_out(out, sites.perturbed, tree, rest, of_rest);
  }
  SiteSet left = sites;
  close_ranks(rest, left, of_rest);
  if (left.coplanar(points)) return 0;
  sites = std::move(left);
  geometry = std::move(of_rest);
  return static_cast<std::int64_t>(all - sites.size());
}

}  // namespace filmsticking
