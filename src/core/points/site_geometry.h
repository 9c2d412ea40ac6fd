// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/vec.h"

namespace filmsticking {

/// What each site's nearest sites say about the surface there. All per site.
struct SiteGeometry {
  /// Side of the square that one sample covers: sqrt(pi r^2 / k), r the distance to the k-th neighbour.
  std::vector<double> spacing;
  std::vector<std::array<Index, 6>> near;  ///< the nearest sites, nearest first, then kNone
  std::vector<Vec3> normal;       ///< unit normal of the plane fitted to the neighbours, of arbitrary sign
  std::vector<double> variation;  ///< the neighbours' variance off that plane over all of it, 0 to 1/3
  std::vector<double> offset;     ///< distance from the neighbours' mean, over their rms distance from it
};

/// Neighbours that describe a site, where there are so many.
constexpr std::size_t kNeighbours = 12;

/// Describes every site by its kNeighbours nearest sites.
SiteGeometry site_geometry(const std::vector<Vec3>& sites);

/// Sets one site's entries from the sites `near` it, itself first.
void describe_site(SiteGeometry& geometry, const std::vector<Vec3>& sites, Index site,
                   const std::vector<Index>& near);

/// Distance to the farthest neighbour of a site that has kNeighbours.
double neighbour_radius(const SiteGeometry& geometry, Index site);

/// Median spacing of the six nearest sites. Unlike the site's own, it is small for a lone site near a
/// surface.
double near_spacing(const SiteGeometry& geometry, Index site);

}  // namespace filmsticking
