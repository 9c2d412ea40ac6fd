// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/vec.h"

namespace filmsticking {

/// What the neighbourhood of each site tells without a surface.
struct SiteGeometry {
  std::vector<double>
      spacing;  ///< sqrt(pi r^2 / k) with r the distance to the k-th neighbour: what one sample covers
  std::vector<std::array<Index, 6>> near;  ///< the nearest sites, nearest first; kNone where there are fewer
  std::vector<Vec3> normal;  ///< unit normal of the plane fitted to the neighbours; its sign says nothing
  std::vector<double> variation;  ///< of the neighbours off that plane: a share of their variance, 0 to 1/3
  std::vector<double> offset;     ///< from the neighbours' mean, in their own distance from it (rms)
};

/// Neighbours of a site, where there are so many.
constexpr std::size_t kNeighbours = 12;

/// From the nearest sites of each.
SiteGeometry site_geometry(const std::vector<Vec3>& sites);

/// Describes one site by its `near`est, itself first.
void describe_site(SiteGeometry& geometry, const std::vector<Vec3>& sites, Index site,
                   const std::vector<Index>& near);

/// How far the farthest neighbour of a site is that has kNeighbours.
double neighbour_radius(const SiteGeometry& geometry, Index site);

/// The median of the spacings of a site's neighbours: unlike its own, small for a lone site near a surface.
double near_spacing(const SiteGeometry& geometry, Index site);

}  // namespace filmsticking
