// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/finish.h"

#include <gtest/gtest.h>

#include <vector>

#include "filmsticking/reconstruct.h"
#include "points/site_set.h"
#include "support/clouds.h"
#include "support/surfaces.h"

namespace filmsticking {
namespace {

// A closed surface of the library, as it was before the last stage: of perturbed sites, and turned over.
struct Unfinished {
  std::vector<Point> points;
  SiteSet sites;
  SiteGeometry geometry;
  Surface surface;

  explicit Unfinished(std::vector<Point> cloud) : points(std::move(cloud)), sites(make_site_set(points)) {
    geometry = site_geometry(sites.perturbed);
    Options options;
    options.sharp_edges = false;
    const Result result = reconstruct(points, options);
    std::vector<Index> site(points.size(), kNone);
    for (std::size_t s = 0; s < sites.size(); ++s) site[sites.input[s]] = static_cast<Index>(s);
    std::vector<Corners> triangles;
    for (const Triangle& t : result.triangles) {
      Corners corners;
      for (int k = 0; k < 3; ++k) corners[k] = site[result.vertices[t[2 - k]]];
      triangles.push_back(corners);
    }
    surface = surface_of_sites(std::move(triangles), sites.perturbed);
  }
  FinishedSurface finish(const FinishOptions& options) const {
    Report report;
    const Execution execution;
    Monitor monitor(execution, report);
    return filmsticking::finish(surface, points, sites, geometry, options, monitor);
  }
};

TEST(Finish, GivesAnOutwardManifoldAtTheExactPlaces) {
  for (const bool sharp_edges : {false, true}) {
    const Unfinished box(test::box(2000, 1, {1, 2, 1}));
    const FinishedSurface done = box.finish({false, sharp_edges, nullptr});
    EXPECT_TRUE(done.usable);
    EXPECT_EQ(done.flips > 0, sharp_edges);
    EXPECT_TRUE(done.topology.check.ok());
    EXPECT_TRUE(test::check(done.surface).ok());
    EXPECT_EQ(done.topology.components, 1);
    EXPECT_GT(test::signed_volume6(done.surface), 0);
    EXPECT_EQ(done.surface.site, box.surface.site);  // no vertex is lost
    for (std::size_t v = 0; v < done.surface.site.size(); ++v)
      EXPECT_EQ(done.surface.positions[v], box.sites.exact(box.points, done.surface.site[v]));
  }
}

TEST(Finish, OfAnOpenSurfaceFillsPinholesAndKeepsTheRim) {
  Unfinished ball(test::sphere(3000, 2));
  ball.surface.triangles.erase(ball.surface.triangles.begin());  // a hole of three edges
  const FinishedSurface closed = ball.finish({true, true, nullptr});
  EXPECT_TRUE(closed.usable);
  EXPECT_TRUE(closed.topology.check.ok());
  std::vector<Corners> half;
  for (std::size_t t = 0; t < ball.surface.triangles.size(); ++t)
    if (test::middle(ball.surface, static_cast<Index>(t)).z() > 0) half.push_back(ball.surface.triangles[t]);
  for (Corners& t : half)
    for (Index& v : t) v = ball.surface.site[v];
  ball.surface = surface_of_sites(std::move(half), ball.sites.perturbed);
  const FinishedSurface open = ball.finish({true, true, nullptr});
  EXPECT_TRUE(open.usable);
  EXPECT_TRUE(open.topology.check.manifold());
  EXPECT_FALSE(open.topology.check.closed);
  // It shows its convex side.
  double outward = 0;
  for (Index t = 0; t < static_cast<Index>(open.surface.triangles.size()); ++t)
    outward += open.surface.area_vector2(t).dot(test::middle(open.surface, t));
  EXPECT_GT(outward, 0);
}

TEST(Finish, RefusesWhatEnclosesNothing) {
  Unfinished ball(test::sphere(300, 3));
  ball.surface = {};
  EXPECT_FALSE(ball.finish({}).usable);
  // A triangle from both sides is closed and flat, and no manifold of distinct faces encloses less.
  std::vector<Point> flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0.25, 0}, {0, 0, 1}};
  const SiteSet sites = make_site_set(flat);
  std::vector<Index> site(flat.size());
  for (std::size_t s = 0; s < sites.size(); ++s) site[sites.input[s]] = static_cast<Index>(s);
  std::vector<Corners> triangles = test::kTetrahedron;
  for (Corners& t : triangles)
    for (Index& v : t) v = site[v];
  Report report;
  const Execution execution;
  Monitor monitor(execution, report);
  const FinishedSurface done = finish(surface_of_sites(triangles, sites.perturbed), flat, sites,
                                      site_geometry(sites.perturbed), {false, false, nullptr}, monitor);
  EXPECT_TRUE(done.topology.check.ok());
  EXPECT_FALSE(done.usable);
}

TEST(Finish, LeavesWhatIsNoManifoldToTheCaller) {
  Unfinished ball(test::sphere(300, 4));
  ball.surface.triangles.push_back(ball.surface.triangles.front());
  const std::vector<Corners> before = ball.surface.triangles;
  const FinishedSurface done = ball.finish({});
  EXPECT_FALSE(done.topology.check.manifold());
  EXPECT_EQ(done.surface.triangles, before);
}

}  // namespace
}  // namespace filmsticking
