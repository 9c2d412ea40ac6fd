// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "report/report.h"
#include "report/surface_distance.h"
#include "support/shapes.h"

namespace filmsticking::mesh_report {
namespace {

using test::box;
using test::joined;
using test::Model;
using test::plane;
using test::sphere;
using test::torus;
using test::triangles;
using test::turned;

TruthDistances distances(const Model& mesh, const Model& truth) {
  const auto result = truth_distances(make_surface(mesh), make_surface(truth), 20'000);
  EXPECT_TRUE(result.has_value());
  return result.value_or(TruthDistances{});
}

TEST(TruthDistances, OfASphereInASphere) {
  // The truth's box has side 2: gaps are halved.
  const TruthDistances near = distances(sphere(0.995), sphere(1));
  EXPECT_NEAR(near.chamfer_e3, 2.5, 0.01);
  EXPECT_NEAR(near.hausdorff, 0.0025, 1e-5);
  EXPECT_EQ(near.f_score, 100);
  EXPECT_GT(near.normal_consistency, 99.9);
  const TruthDistances far = distances(sphere(0.9), sphere(1));
  EXPECT_NEAR(far.chamfer_e3, 50, 0.03);
  EXPECT_NEAR(far.hausdorff, 0.05, 3e-5);
  EXPECT_EQ(far.f_score, 0);
}

TEST(TruthDistances, OfAShiftedPlane) {
  // Also from sides and with an origin of their own: the truth's box is brought to the unit box.
  for (const double size : {1.0, 250.0}) {
    const Point origin{1000 * size, -3 * size, 0};
    const Model truth = plane(origin, {size, 0, 0}, {0, size, 0}, 7);
    const auto shifted = [&](double by) {
      return plane({origin[0], origin[1], by * size}, {0, size, 0}, {size, 0, 0}, 3);
    };
    for (const double by : {0.004, 0.006}) {
      const TruthDistances d = distances(shifted(by), truth);
      EXPECT_NEAR(d.chamfer_e3, 1000 * by, 1e-7);
      EXPECT_NEAR(d.hausdorff, by, 1e-10);
      EXPECT_EQ(d.f_score, by < 0.005 ? 100 : 0);
      EXPECT_NEAR(d.normal_consistency, 100, 1e-7);
    }
  }
}

TEST(TruthDistances, OfHalfAPlane) {
  // All of the half is on the whole; of the whole 0.505 is near, and the mean distance is 1/8.
  const TruthDistances d =
      distances(plane({0, 0, 0}, {0.5, 0, 0}, {0, 1, 0}, 4), plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 4));
  EXPECT_NEAR(d.f_score, 100 * 2 * 0.505 / 1.505, 1);
  EXPECT_NEAR(d.chamfer_e3, 62.5, 2);
  EXPECT_NEAR(d.hausdorff, 0.5, 0.001);
  EXPECT_NEAR(d.normal_consistency, 100, 1e-9);
}

TEST(TruthDistances, NormalsOfATiltedPlane) {
  const double angle = 0.3;
  const Model truth = plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1);
  const Model tilted = plane({0, 0, 0}, {std::cos(angle), 0, std::sin(angle)}, {0, 1, 0}, 1);
  EXPECT_NEAR(distances(tilted, truth).normal_consistency, 100 * std::cos(angle), 1e-9);
  EXPECT_NEAR(distances(turned(tilted), truth).normal_consistency, 100 * std::cos(angle), 1e-9);
}

TEST(TruthDistances, PartsThatAreTurnedOver) {
  const Model truth = plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 2);
  for (const double share : {0.0, 0.3, 0.8}) {
    Model mesh = plane({share, 0, 0.001}, {1 - share, 0, 0}, {0, 1, 0}, 3);
    if (share > 0) mesh = joined(mesh, turned(plane({0, 0, 0.001}, {share, 0, 0}, {0, 1, 0}, 3)));
    const double expected = 100 * std::min(share, 1 - share);
    EXPECT_NEAR(distances(mesh, truth).turned_over, expected, 1) << share;
    EXPECT_NEAR(distances(turned(mesh), truth).turned_over, expected, 1) << share;
    EXPECT_NEAR(distances(mesh, truth).normal_consistency, 100, 1e-9);
  }
}

TEST(TruthDistances, FacesWithoutAreaChangeNothing) {
  Model mesh = plane({0, 0, 0.01}, {1, 0, 0}, {0, 1, 0}, 2);
  mesh.triangles.insert(mesh.triangles.begin(), {0, 1, 2});  // on one line
  const TruthDistances d = distances(mesh, plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 2));
  EXPECT_NEAR(d.chamfer_e3, 10, 1e-7);
  EXPECT_NEAR(d.hausdorff, 0.01, 1e-9);
}

TEST(SurfaceDistance, AFaceOnOneLineIsItsLongestSide) {
  std::array<std::int32_t, 3> corners{0, 1, 2};
  do {
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(-1, -2, -3), Vec3(0.1, 0.7, -0.3)}) {
      const Surface line{{0 * axis, 1 * axis, 3 * axis}, {corners}};
      const Vec3 aside = axis.unitOrthogonal();
      const auto nearest = SurfaceDistance(line).from({aside, 3 * axis + aside, 2 * axis - aside, 5 * axis});
      for (int i = 0; i < 3; ++i) EXPECT_NEAR(nearest[i].distance, 1, 1e-12);
      EXPECT_NEAR(nearest[3].distance, 2 * axis.norm(), 1e-12);
    }
  } while (std::next_permutation(corners.begin(), corners.end()));
}

TEST(TruthDistances, NoneWithoutExtentOrArea) {
  const Model line = triangles({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}});
  EXPECT_FALSE(truth_distances(make_surface(box()), make_surface(line)));
  EXPECT_FALSE(truth_distances(make_surface(line), make_surface(box())));
  EXPECT_FALSE(truth_distances(make_surface(box()), make_surface({})));
}

TEST(TruthFit, TopologyIsRightOrNot) {
  const auto fit = [](const Model& mesh, const Model& truth) {
    const Surface surface = make_surface(mesh);
    return truth_fit(surface, topology(surface), make_surface(truth), 10);
  };
  Model open = box();
  open.triangles.resize(10);
  const Model two = joined(box(), box({3, 0, 0}, {4, 1, 1}));
  EXPECT_TRUE(fit(box(), sphere(1)).topology_right());
  EXPECT_FALSE(fit(torus(), box()).genus_right);
  EXPECT_TRUE(fit(torus(), box()).components_right);
  EXPECT_FALSE(fit(torus(), box()).topology_right());
  EXPECT_TRUE(fit(two, box()).genus_right);
  EXPECT_FALSE(fit(two, box()).components_right);
  EXPECT_FALSE(fit(two, box()).topology_right());
  EXPECT_FALSE(fit(open, box()).topology_right());
  EXPECT_FALSE(fit(box(), open).topology_right());
  EXPECT_FALSE(fit(open, open).topology_right());
}

}  // namespace
}  // namespace filmsticking::mesh_report
