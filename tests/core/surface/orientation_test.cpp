// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/orientation.h"

#include <gtest/gtest.h>

#include <vector>

#include "geometry/enclosed_volume.h"
#include "support/surfaces.h"

namespace filmsticking {
namespace {

TEST(Orientation, TheTruePlacesSayWhatIsOutward) {
  Surface surface;  // perturbed, the tip came out on the other side of its base
  surface.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, -1e-8}};
  surface.site.assign(4, kNone);
  surface.triangles.assign(std::begin(test::kTetrahedron), std::end(test::kTetrahedron));
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
  Surface surface;
  surface.positions = {{-4, -4, 0},  {4, -4, 0},    {0, 4, 0},     {0, 0, 1e-8},
                       {0, 0, 1e-9}, {0.5, 0, 0.5}, {0, 0.5, 0.5}, {0, 0, 0.7}};
  surface.site.assign(8, kNone);
  for (const Index first : {0, 4})
    for (const Corners& t : test::kTetrahedron)
      surface.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  std::vector<Point> places = test::places_of(surface);
  places[3] = {0, 0, 0};
  EXPECT_TRUE(orient_components(surface, places, SurfaceTopology(surface.triangles, 8)));
  EXPECT_EQ(enclosed_volume_sign({surface.triangles.begin() + 4, surface.triangles.end()}, places), 1);
}

TEST(Orientation, TurnsSolidsOutwardAndCavitiesInward) {
  Surface nested;
  for (const double size : {4.0, 1.0, 0.2}) {  // solid, cavity, solid in the cavity
    const Index first = static_cast<Index>(nested.positions.size());
    for (const Vec3& p : {Vec3(-1, -1, -1), Vec3(1, 1, -1), Vec3(1, -1, 1), Vec3(-1, 1, 1)})
      nested.positions.push_back(size * p), nested.site.push_back(kNone);
    for (const Corners& t : test::kTetrahedron)
      nested.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  for (int flips = 0; flips < 8; ++flips) {
    Surface turned = nested;
    for (std::size_t t = 0; t < turned.triangles.size(); ++t)
      if (flips >> (t / 4) & 1) std::swap(turned.triangles[t][1], turned.triangles[t][2]);
    const SurfaceTopology topology(turned.triangles, static_cast<Index>(turned.positions.size()));
    EXPECT_TRUE(orient_components(turned, test::places_of(turned), topology));
    for (int part = 0; part < 3; ++part) {
      Surface one = turned;
      one.triangles.assign(turned.triangles.begin() + 4 * part, turned.triangles.begin() + 4 * part + 4);
      EXPECT_EQ(test::signed_volume6(one) > 0, part != 1) << flips << ' ' << part;
    }
  }
}

}  // namespace
}  // namespace filmsticking
