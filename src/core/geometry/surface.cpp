// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

namespace filmsticking {

Surface unsorted_surface_of_sites(std::vector<Corners> triangles, const std::vector<Vec3>& sites) {
  Surface surface;
  std::vector<Index> vertex(sites.size(), kNone);
  for (const Corners& t : triangles)
    for (Index s : t) vertex[s] = 0;
  for (std::size_t s = 0; s < sites.size(); ++s)
    if (vertex[s] != kNone) {
      vertex[s] = static_cast<Index>(surface.positions.size());
      surface.positions.push_back(sites[s]);
      surface.site.push_back(static_cast<Index>(s));
    }
  for (Corners& t : triangles)
    for (Index& s : t) s = vertex[s];
  surface.triangles = std::move(triangles);
  return surface;
}

Surface surface_of_sites(std::vector<Corners> triangles, const std::vector<Vec3>& sites) {
  Surface surface = unsorted_surface_of_sites(std::move(triangles), sites);
  for (Corners& t : surface.triangles) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::sort(surface.triangles.begin(), surface.triangles.end());
  return surface;
}

std::int64_t sites_on(const Surface& surface, std::size_t points) {
  return std::count_if(surface.site.begin(), surface.site.end(),
                       [&](Index s) { return s != kNone && static_cast<std::size_t>(s) < points; });
}

Vec3 Surface::area_vector2(Index triangle) const {
  const Vec3 a = corner(triangle, 0);
  return (corner(triangle, 1) - a).cross(corner(triangle, 2) - a);
}

}  // namespace filmsticking
