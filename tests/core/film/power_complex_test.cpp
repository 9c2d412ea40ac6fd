// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/power_complex.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "delaunay/delaunay.h"
#include "points/site_set.h"
#include "support/clouds.h"
#include "support/power_cells.h"

namespace filmsticking {
namespace {

std::vector<double> random_weights(std::size_t n, std::uint64_t seed) {
  test::Random random(seed);
  std::vector<double> weights(n);
  for (double& w : weights) w = random.uniform(0, 0.01);
  return weights;
}

// The least power at the orthocentre is that of the corners, all equal: the orthosphere is empty.
TEST(PowerComplex, OrthospheresAreEmpty) {
  const std::vector<Vec3> sites = test::random_sites(200, 1);
  for (const std::vector<double>& weights : {std::vector<double>{}, random_weights(200, 2)}) {
    const PowerComplex complex(sites, weights, {});
    ASSERT_GT(complex.size(), 400u);
    for (std::size_t t = 0; t < complex.size(); ++t) {
      if (complex.tetrahedra().infinite(static_cast<Index>(t)) || complex.flat(t)) continue;
      const Vec3& x = complex.orthocentre(t);
      const auto& corners = complex.tetrahedra().corners[t];
      const double own = test::power(sites, weights, static_cast<std::size_t>(corners[0]), x);
      const double rounding = 1e-6 * (1 + x.squaredNorm());
      for (const Index v : corners)
        EXPECT_NEAR(test::power(sites, weights, static_cast<std::size_t>(v), x), own, rounding);
      for (std::size_t i = 0; i < sites.size(); ++i)
        EXPECT_GE(test::power(sites, weights, i, x), own - rounding);
    }
  }
}

TEST(PowerComplex, LocatesFromAnywhere) {
  const std::vector<Vec3> sites = test::random_sites(300, 3);
  const PowerComplex complex(sites, random_weights(300, 4), {});
  test::Random random(5);
  for (int i = 0; i < 500; ++i) {
    const Vec3 x(random.uniform(-0.7, 0.7), random.uniform(-0.7, 0.7), random.uniform(-0.7, 0.7));
    const Index t = complex.locate(x, random.below(300));
    const auto& c = complex.tetrahedra().corners[t];
    for (int k = 0; k < 4; ++k) {
      const Index f[3] = {c[kFacet[k][0]], c[kFacet[k][1]], c[kFacet[k][2]]};
      if (std::count(f, f + 3, kNone) > 0) continue;
      EXPECT_LE((sites[f[1]] - sites[f[0]]).cross(sites[f[2]] - sites[f[0]]).dot(x - sites[f[0]]), 1e-12);
    }
  }
}

// The lemma that makes the evolution end: circumradii rise along the map.
TEST(FlowMap, RadiiRiseUntilAMaximumOrInfinity) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const SiteSet set = make_site_set(test::awkward(seed));
    if (set.size() < 5) continue;
    const TetrahedralMesh mesh = make_tetrahedral_mesh(delaunay_tetrahedra(set.perturbed), set.perturbed);
    const UnsetVector<Index> flow = flow_map(mesh, set.perturbed);
    for (std::size_t t = 0; t < mesh.size(); ++t) {
      const auto own = static_cast<Index>(t);
      if (mesh.tets.infinite(own)) {
        EXPECT_EQ(flow[t], own);
      } else if (mesh.circumradius[t] < 1e3) {  // beyond, rounding decides
        EXPECT_GE(mesh.circumradius[flow[t]], mesh.circumradius[t] * (1 - 1e-6));
      }
    }
  }
}

TEST(FlowMap, IsThatOfTheComplex) {
  const SiteSet set = make_site_set(test::torus(2000, 6));
  const TetrahedralMesh mesh = make_tetrahedral_mesh(delaunay_tetrahedra(set.perturbed), set.perturbed);
  const PowerComplex complex(set.perturbed, mesh.tets);
  EXPECT_TRUE(flow_map(mesh, set.perturbed) == complex.flow());
  std::vector<char> some(mesh.size(), 0);
  some[100] = 1;
  EXPECT_EQ(flow_map(mesh, set.perturbed, some)[100], complex.flow()[100]);
}

}  // namespace
}  // namespace filmsticking
