// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/dual_complex.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "film/initial_surface.h"
#include "geometry/triangle_adjacency.h"
#include "points/site_set.h"
#include "support/clouds.h"
#include "support/film_check.h"

namespace filmsticking {
namespace {

TEST(DualComplex, IsClosedWhateverTheSites) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const std::vector<Point> points = test::awkward(seed);
    const SiteSet set = make_site_set(points);
    if (set.size() < 4) continue;
    std::vector<Vec3> exact;  // ties and all
    for (std::size_t s = 0; s < set.size(); ++s) exact.push_back(set.exact(points, s));
    const PowerDiagram diagram = DelaunayTriangulation(exact).voronoi();
    if (diagram.any_site == kNone) continue;
    const Surface sphere = bounding_sphere(exact);
    const auto restricted = restrict_power_diagram(
        sphere, half_edge_twins(sphere.triangles, static_cast<Index>(sphere.positions.size())), diagram);
    test::expect_closed(dual_complex(sphere, restricted, diagram));
  }
}

TEST(DualComplex, TriplePointsAreEquallyFarFromTheirSites) {
  const SiteSet set = make_site_set(test::sphere(400, 1));
  const PowerDiagram diagram = DelaunayTriangulation(set.perturbed).voronoi();
  const Surface sphere = bounding_sphere(set.perturbed);
  const auto restricted = restrict_power_diagram(
      sphere, half_edge_twins(sphere.triangles, static_cast<Index>(sphere.positions.size())), diagram);
  const HalfEdgeComplex dual = dual_complex(sphere, restricted, diagram);
  ASSERT_FALSE(dual.point.empty());
  for (std::size_t t = 0; t < dual.point.size(); ++t) {
    const double d = diagram.power(dual.site[3 * t], dual.point[t]);
    for (int k = 1; k < 3; ++k) EXPECT_NEAR(diagram.power(dual.site[3 * t + k], dual.point[t]), d, 1e-9);
    EXPECT_NEAR(diagram.power(diagram.owner(dual.point[t], kNone), dual.point[t]), d, 1e-9);
  }
}

}  // namespace
}  // namespace filmsticking
