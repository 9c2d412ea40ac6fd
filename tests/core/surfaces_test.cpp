// SPDX-License-Identifier: GPL-3.0-or-later
// Adjacency, first surfaces, orientation.
#include <gtest/gtest.h>

#include "enclosed_volume.h"
#include "film_normals.h"
#include "guiding_surface.h"
#include "orientation.h"
#include "site_set.h"
#include "support/clouds.h"
#include "triangle_adjacency.h"

namespace filmsticking {
namespace {

const std::vector<Corners> kTetrahedron{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

TEST(TriangleAdjacency, AcceptsAClosedManifold) { EXPECT_TRUE(check_manifold(kTetrahedron, 4).ok()); }

TEST(TriangleAdjacency, SeesEveryKindOfFault) {
  EXPECT_FALSE(check_manifold({}, 0).ok());
  EXPECT_FALSE(check_manifold({{0, 1, 9}}, 3).indices_valid);
  EXPECT_FALSE(check_manifold({{0, 1, 1}}, 3).indices_valid);
  auto open = kTetrahedron;
  open.pop_back();
  EXPECT_FALSE(check_manifold(open, 4).closed);
  auto turned = kTetrahedron;
  std::swap(turned[0][0], turned[0][1]);
  EXPECT_FALSE(check_manifold(turned, 4).oriented);
  auto bow_tie = kTetrahedron;  // two tetrahedra that share corner 0 only
  for (const Corners& t : kTetrahedron) {
    Corners u;
    for (int k = 0; k < 3; ++k) u[k] = t[k] == 0 ? 0 : t[k] + 3;
    bow_tie.push_back(u);
  }
  const ManifoldCheck check = check_manifold(bow_tie, 7);
  EXPECT_TRUE(check.closed && check.oriented);
  EXPECT_FALSE(check.single_rings);
  std::vector<Index> component;
  EXPECT_EQ(connected_components(half_edge_twins(bow_tie, 7), component), 2);
}

TEST(GuidingSurface, SphereHoldsTheSites) {
  const SiteSet set = make_site_set(test::grid(4));
  const GuidingSurface sphere = bounding_sphere(set.perturbed);
  EXPECT_TRUE(check_manifold(sphere.triangles, static_cast<Index>(sphere.positions.size())).ok());
  EXPECT_GT(signed_volume6(sphere), 0);
  for (const Corners& t : sphere.triangles) {
    const Vec3 &a = sphere.positions[t[0]], &b = sphere.positions[t[1]], &c = sphere.positions[t[2]];
    const Vec3 outward = (b - a).cross(c - a);
    for (const Vec3& p : set.perturbed) EXPECT_LT(outward.dot(p - a), 0);
  }
}

TEST(FilmNormals, AreOutwardAndLeaveOtherSitesAlone) {
  GuidingSurface sphere = bounding_sphere(make_site_set(test::grid(2)).perturbed);
  const std::size_t n = sphere.positions.size();
  for (std::size_t v = 0; v < n; ++v) sphere.site[v] = static_cast<Index>(v + 1);  // site 0 is off it
  const Vec3 otherwise(0, 0.6, -0.8);
  const std::vector<Vec3> normals = film_normals(sphere, std::vector<Vec3>(n + 1, otherwise));
  EXPECT_EQ(normals[0], otherwise);
  for (std::size_t v = 0; v < n; ++v) {
    EXPECT_NEAR(normals[v + 1].norm(), 1, 1e-12);
    EXPECT_GT(normals[v + 1].dot(sphere.positions[v].normalized()), 0.999);
  }
  for (Vec3& p : sphere.positions) p = {p.x(), 0, 0};  // flat: there is no normal
  for (const Vec3& normal : film_normals(sphere, std::vector<Vec3>(n + 1, otherwise)))
    EXPECT_EQ(normal, otherwise);
}

TEST(GuidingSurface, WrapIsClosedAndHoldsTheSites) {
  const SiteSet set = make_site_set(test::torus(3000, 3));
  const GuidingSurface wrap = alpha_wrap(set.perturbed, 0.1);
  EXPECT_TRUE(check_manifold(wrap.triangles, static_cast<Index>(wrap.positions.size())).ok());
  std::vector<Index> all;
  for (std::size_t t = 0; t < wrap.triangles.size(); ++t) all.push_back(static_cast<Index>(t));
  for (std::size_t s = 0; s < set.size(); s += 50)
    EXPECT_NEAR(solid_angle_winding(wrap, all, set.perturbed[s]), 1, 1e-6);
}

std::vector<Point> places_of(const GuidingSurface& surface) {
  std::vector<Point> places;
  for (const Vec3& p : surface.positions) places.push_back({p.x(), p.y(), p.z()});
  return places;
}

TEST(Orientation, TheTruePlacesSayWhatIsOutward) {
  GuidingSurface surface;  // perturbed, the tip came out on the other side of its base
  surface.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, -1e-8}};
  surface.site.assign(4, kNone);
  surface.triangles.assign(std::begin(kTetrahedron), std::end(kTetrahedron));
  for (const double tip : {1e-12, -1e-12, 1e-300, -1e-300}) {
    const std::vector<Point> places = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, tip}};
    EXPECT_TRUE(orient_components(surface, places, SurfaceTopology(surface.triangles, 4)));
    EXPECT_EQ(enclosed_volume_sign(surface.triangles, places), 1);
  }
  const std::vector<Point> flat = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, 0}};
  EXPECT_FALSE(orient_components(surface, flat, SurfaceTopology(surface.triangles, 4)));
}

// A solid with a corner between the sides of one that is flat but for the perturbation was turned as its
// cavity.
TEST(Orientation, Regression_AFlatComponentHoldsNothing) {
  GuidingSurface surface;
  surface.positions = {{-4, -4, 0},  {4, -4, 0},    {0, 4, 0},     {0, 0, 1e-8},
                       {0, 0, 1e-9}, {0.5, 0, 0.5}, {0, 0.5, 0.5}, {0, 0, 0.7}};
  surface.site.assign(8, kNone);
  for (const Index first : {0, 4})
    for (const Corners& t : kTetrahedron)
      surface.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  std::vector<Point> places = places_of(surface);
  places[3] = {0, 0, 0};
  EXPECT_TRUE(orient_components(surface, places, SurfaceTopology(surface.triangles, 8)));
  EXPECT_EQ(enclosed_volume_sign({surface.triangles.begin() + 4, surface.triangles.end()}, places), 1);
}

TEST(EnclosedVolume, IsExactAtEveryScale) {
  const std::vector<Corners> triangles(std::begin(kTetrahedron), std::end(kTetrahedron));
  const auto sign = [&](double x, double y, double z, const Point& o) {
    return enclosed_volume_sign(
        triangles,
        std::vector<Point>{o, {o[0] + x, o[1], o[2]}, {o[0], o[1] + y, o[2]}, {o[0], o[1], o[2] + z}});
  };
  const int outward = sign(1, 1, 1, {0, 0, 0});
  EXPECT_EQ(std::abs(outward), 1);
  EXPECT_EQ(sign(1, 1, -1, {0, 0, 0}), -outward);
  EXPECT_EQ(sign(1, 1, 0, {0, 0, 0}), 0);
  EXPECT_EQ(sign(1e308, 1e308, -1e308, {0, 0, 0}), -outward);
  EXPECT_EQ(sign(1e308, 1e-200, 1e-200, {0, 0, 0}), outward);
  EXPECT_EQ(sign(5e-324, -5e-324, 5e-324, {0, 0, 0}), -outward);
  EXPECT_EQ(sign(1e300, 1e300, 1e300, {-1e308, 1e308, 1e308}), outward);
  EXPECT_EQ(sign(1, 1, 1e-9, {1e6, 1e6, 1e6}), outward);
  EXPECT_EQ(sign(1, 1, 1e-12, {1e6, 1e6, 1e6}), 0);  // rounded away already
  EXPECT_EQ(enclosed_volume_sign({}, std::vector<Point>()), 0);
}

TEST(Orientation, TurnsSolidsOutwardAndCavitiesInward) {
  GuidingSurface nested;
  for (const double size : {4.0, 1.0, 0.2}) {  // solid, cavity, solid in the cavity
    const Index first = static_cast<Index>(nested.positions.size());
    for (const Vec3& p : {Vec3(-1, -1, -1), Vec3(1, 1, -1), Vec3(1, -1, 1), Vec3(-1, 1, 1)})
      nested.positions.push_back(size * p), nested.site.push_back(kNone);
    for (const Corners& t : kTetrahedron)
      nested.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  for (int flips = 0; flips < 8; ++flips) {
    GuidingSurface turned = nested;
    for (std::size_t t = 0; t < turned.triangles.size(); ++t)
      if (flips >> (t / 4) & 1) std::swap(turned.triangles[t][1], turned.triangles[t][2]);
    const SurfaceTopology topology(turned.triangles, static_cast<Index>(turned.positions.size()));
    EXPECT_TRUE(orient_components(turned, places_of(turned), topology));
    for (int part = 0; part < 3; ++part) {
      GuidingSurface one = turned;
      one.triangles.assign(turned.triangles.begin() + 4 * part, turned.triangles.begin() + 4 * part + 4);
      EXPECT_EQ(signed_volume6(one) > 0, part != 1) << flips << ' ' << part;
    }
  }
}

}  // namespace
}  // namespace filmsticking
