// SPDX-License-Identifier: GPL-3.0-or-later
// What the rooms count: each counter's bound, which follows from what is counted, whatever the cloud; and
// that those of repairs are (next to) none on clean clouds, so that none of them hides a defect.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "evidence/signed_field.h"
#include "film/dual_complex.h"
#include "film/film.h"
#include "film/initial_surface.h"
#include "filmsticking/reconstruct.h"
#include "geometry/triangle_adjacency.h"
#include "labelling/label_islands.h"
#include "labelling/manifold_labels.h"
#include "labelling/sculpt.h"
#include "points/site_set.h"
#include "support/clouds.h"
#include "support/field_setting.h"

namespace filmsticking {
namespace {

// On the golden spiral of an ellipsoid, each shaken by up to a fifth of the spacing.
std::vector<Point> even_ellipsoid(int n, std::uint64_t seed) {
  test::Random random(seed);
  std::vector<Point> points;
  for (int i = 0; i < n; ++i) {
    const double z = 1 - (2 * i + 1.) / n, turn = 2.399963229728653 * i, r = std::sqrt(1 - z * z);
    const double shake = 0.2 * std::sqrt(4 * M_PI / n);
    Point p{r * std::cos(turn), r * std::sin(turn), z};
    for (double& x : p) x += shake * random.uniform(-1, 1);
    const double length = std::hypot(p[0], p[1], p[2]);
    points.push_back({p[0] / length, 0.8 * p[1] / length, 0.6 * p[2] / length});
  }
  return points;
}

std::map<std::string, std::vector<Point>> clean_clouds() {
  std::map<std::string, std::vector<Point>> clouds;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const std::string name = " " + std::to_string(seed);
    clouds["sphere" + name] = test::sphere(2000, seed);
    clouds["torus" + name] = test::torus(3000, seed);
    clouds["even ellipsoid" + name] = even_ellipsoid(2000, seed);
    clouds["block" + name] = test::box(3000, seed, {1, 1, 1});
    auto two = even_ellipsoid(1500, seed);
    for (Point p : test::torus(2000, seed)) p[0] += 4, two.push_back(p);
    clouds["two" + name] = two;
  }
  clouds["spot"] = test::read_float_ply(TEST_DATA "/spot_10k.ply");
  return clouds;
}

struct Setting : test::FieldSetting {
  LabelCosts costs;
  std::vector<char> cut;  // by the evidence alone

  explicit Setting(const std::vector<Point>& points) : FieldSetting(points), costs(costs_of(*this)) {
    const auto belief = signed_field(mesh, evidence, std::vector<double>(mesh.size(), 0));
    for (std::size_t t = 0; t < mesh.size(); ++t)
      for (const double area : evidence.area[t]) costs.hold[t] += 0.1 * area * belief[t];
    cut = Sculptor(mesh, evidence, costs.hold).cut();
  }

  std::int64_t euler(const std::vector<char>& inside) const {
    return euler_if_manifold(*this, inside).value();
  }
  std::int64_t pieces(const std::vector<char>& inside) const {
    std::vector<Index> piece;
    return label_pieces(mesh, inside, piece);
  }
  std::size_t on(const std::vector<char>& inside) const { return film_of(*this, inside).site.size(); }
};

std::int64_t differences(const std::vector<char>& a, const std::vector<char>& b) {
  std::int64_t count = 0;
  for (std::size_t t = 0; t < a.size(); ++t) count += a[t] != b[t];
  return count;
}

// For any labels.
void expect_bounds(const Setting& s, std::vector<char> inside, const std::vector<char>& aim) {
  const std::vector<char> before = inside;
  const auto sites = static_cast<std::int64_t>(s.set.size());
  ManifoldLabels labels(s.mesh, s.geometry, s.costs, inside);
  const LabelCounts& counts = labels.counts();
  labels.repair();
  EXPECT_LE(counts.singular, sites);
  EXPECT_EQ(counts.repairs + counts.erosions > 0, counts.singular > 0);
  EXPECT_EQ(differences(before, inside) > 0, counts.islands + counts.repairs + counts.erosions > 0);
  EXPECT_LE(counts.erosions, static_cast<std::int64_t>(s.mesh.size()));  // each takes one from the inside

  const std::int64_t apart = differences(inside, aim);
  labels.warp(aim);
  EXPECT_EQ(differences(inside, aim), apart - counts.warped);  // one less with each

  labels.unfold();
  const auto flat = std::count_if(s.mesh.flat.begin(), s.mesh.flat.end(), [](int side) { return side != 0; });
  EXPECT_LE(counts.unfolded, 8 * static_cast<std::int64_t>(flat));

  const std::vector<char> warped = inside;
  labels.reach();
  EXPECT_LE(counts.reached, 8 * sites);
  EXPECT_EQ(counts.reached > 0, differences(warped, inside) > 0);

  const std::int64_t euler = s.euler(inside), pieces = s.pieces(inside);
  labels.fill_gaps(s.set.perturbed);
  // Of a surface, pieces of both labels are components and one more; Euler's characteristic is twice what
  // there are more components than handles. A plug that is taken leaves neither more pieces nor, in sum, as
  // many.
  const std::int64_t fewer_pieces = pieces - s.pieces(inside),
                     fewer_handles = (s.euler(inside) - euler) / 2 + fewer_pieces;
  EXPECT_GE(fewer_pieces, counts.tears);
  EXPECT_GE(fewer_handles + fewer_pieces, counts.tunnels + counts.tears);
}

TEST(Counters, OfLabelsKeepTheirBounds) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    const Setting s(seed % 2 ? test::sphere(150, seed) : test::torus(250, seed));
    test::Random random(seed);
    std::vector<char> inside(s.mesh.size()), aim(s.mesh.size());
    for (std::size_t t = 0; t < inside.size(); ++t) {
      if (s.mesh.tets.infinite(static_cast<Index>(t))) continue;
      inside[t] = random.below(3) > 0, aim[t] = random.below(2) > 0;
    }
    expect_bounds(s, inside, aim);
  }
}

TEST(Counters, OfLabelsAreSmallOnCleanClouds) {
  for (const auto& [name, points] : clean_clouds()) {
    SCOPED_TRACE(name);
    const Setting s(points);
    const double sites = static_cast<double>(s.set.size());
    std::vector<char> inside = s.cut;
    ManifoldLabels labels(s.mesh, s.geometry, s.costs, inside);
    labels.repair();
    labels.warp(s.cut);
    labels.reach();
    labels.fill_gaps(s.set.perturbed);
    const LabelCounts& c = labels.counts();
    // The cut of points that are dense beside the shape's features is one already; chance leaves a point or
    // two off.
    EXPECT_LE(static_cast<double>(c.singular), sites / 500);
    EXPECT_LE(c.repairs, 2 * c.singular);
    EXPECT_EQ(c.islands, 0);
    EXPECT_EQ(c.erosions, 0);
    EXPECT_EQ(c.tunnels, 0);
    EXPECT_EQ(c.tears, 0);
    EXPECT_LE(static_cast<double>(c.reached), sites / 200);
    EXPECT_EQ(s.on(inside), s.set.size());
  }
}

TEST(Counters, OfFilmStepsKeepTheirBounds) {
  for (const auto& [name, points] : clean_clouds()) {
    if (name.find('1') == std::string::npos) continue;
    SCOPED_TRACE(name);
    const SiteSet set = make_site_set(points);
    const PowerDiagram diagram = DelaunayTriangulation(set.perturbed).voronoi();
    Surface film = bounding_sphere(set.perturbed);
    for (int step = 0; step < 12 && !film.triangles.empty(); ++step) {
      const auto restricted = restrict_power_diagram(
          film, half_edge_twins(film.triangles, static_cast<Index>(film.positions.size())), diagram);
      const HalfEdgeComplex dual = dual_complex(film, restricted, diagram);
      RepairCounts counts;
      film = surface_of_sites(repair_half_edges(dual, diagram.position, RingChoice::Smooth, counts),
                              diagram.position);
      const auto cut = static_cast<std::int64_t>(dual.point.size()),
                 left = static_cast<std::int64_t>(film.triangles.size());
      EXPECT_EQ(restricted.jumps, 0);
      // What is removed takes two triangles along at least, and nothing adds any.
      EXPECT_LE(left, cut - 2 * (counts.surplus_regions + counts.thin_regions));
      EXPECT_EQ(counts.cuts, 0);
      EXPECT_LE(counts.flips, cut / 100);
      // Each site of these is met from outside at once, in one region.
      if (name.find("sphere") == 0 || name.find("even") == 0) {
        EXPECT_EQ(counts.total(), 0);
      }
    }
  }
}

TEST(Counters, OfAReportAddUp) {
  for (const auto& [name, clean] : clean_clouds()) {
    if (name.find('2') == std::string::npos) continue;
    SCOPED_TRACE(name);
    std::vector<Point> points = clean;
    for (int i = 0; i < 30; ++i) points.push_back(clean[static_cast<std::size_t>(7 * i)]);
    for (const double strange : {std::nan(""), HUGE_VAL, -HUGE_VAL}) points.push_back({0, strange, 0});
    for (const double far : {-40., 40.}) points.push_back({far, 2 * far, far});
    const Result result = reconstruct(points);
    ASSERT_EQ(result.status, Status::Ok) << result.message;
    const Report& r = result.report;
    EXPECT_EQ(r.points, static_cast<std::int64_t>(points.size()));
    EXPECT_EQ(r.non_finite, 3);
    EXPECT_EQ(r.duplicates, 30);
    EXPECT_EQ(r.sites, static_cast<std::int64_t>(clean.size()) + 2);
    EXPECT_EQ(r.outliers, 2);
    EXPECT_EQ(r.interpolated, r.sites - r.outliers);
    EXPECT_LE(r.inserted, r.interpolated / 200);
    EXPECT_TRUE(r.steps.empty());  // no film stepped in
    EXPECT_EQ(r.rounds, 0);
    EXPECT_EQ(r.boundary_edges, 0);
    EXPECT_EQ(r.boundary_loops, 0);
    // Of a closed surface: V - E + F = 2 (components - genus), and three edges for two faces.
    EXPECT_EQ(r.interpolated - r.triangles / 2, 2 * (r.components - r.genus));
  }
}

}  // namespace
}  // namespace filmsticking
