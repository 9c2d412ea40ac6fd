// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "geometry/vec.h"

namespace filmsticking {

/// What each site's neighbours say about the surface there. All per site.
///
/// The neighbours are the kNeighbours nearest sites. Where those lie along a curve, as in one slice or one
/// scan line, they do not show the surface: twice as many are asked until they do, kMostNeighbours at most.
/// If none do, the first ones stay.
struct SiteGeometry {
  /// Side of the square that one sample covers: sqrt(pi r^2 / k), r the distance to the k-th neighbour.
  std::vector<double> spacing;
  std::vector<double> radius;              ///< distance to the farthest neighbour
  std::vector<std::array<Index, 6>> near;  ///< the nearest sites, nearest first, then kNone
  std::vector<Vec3> normal;       ///< unit normal of the plane fitted to the neighbours, of arbitrary sign
  std::vector<double> variation;  ///< the neighbours' variance off that plane over all of it, 0 to 1/3
  std::vector<double> offset;     ///< distance from the neighbours' mean, over their rms distance from it
};

/// Neighbours that describe a site, where there are so many; and the most.
constexpr std::size_t kNeighbours = 12, kMostNeighbours = 192;

/// The nearest sites to a site, itself first: so many, or all if there are fewer.
using NearestSites = std::function<std::vector<Index>(std::size_t)>;

/// Describes every site.
SiteGeometry site_geometry(const std::vector<Vec3>& sites);

/// Sets one site's entries.
void describe_site(SiteGeometry& geometry, const std::vector<Vec3>& sites, Index site,
                   const NearestSites& nearest);

/// Median spacing of the six nearest sites. Unlike the site's own, it is small for a lone site near a
/// surface.
double near_spacing(const SiteGeometry& geometry, Index site);

}  // namespace filmsticking
