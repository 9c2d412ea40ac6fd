// SPDX-License-Identifier: GPL-3.0-or-later
// Flips to the features of a shape: what is promised of them, over films of the pipeline.
#include "surface/feature_flips.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "filmsticking/reconstruct.h"
#include "geometry/meeting.h"
#include "geometry/triangle_adjacency.h"
#include "support/clouds.h"
#include "support/surface_check.h"

namespace filmsticking {
namespace {

std::map<std::string, std::vector<Point>> clouds() {
  return {{"sphere", test::sphere(3000, 1)},
          {"torus", test::torus(3000, 2)},
          {"box", test::box(3000, 3, {1, 2, 0.5})},
          {"plate", test::box(2000, 4, {1, 1, 0.03})},
          {"grid", test::grid(7)},
          {"spot", test::read_float_ply(TEST_DATA "/spot_10k.ply")}};
}

Result without_flips(const std::vector<Point>& points) {
  Options options;
  options.sharp_edges = false;
  return reconstruct(points, options);
}

// The film in the box [0, 1]^3, its faces in the result's order.
Surface film_of(const Result& result, const std::vector<Point>& points) {
  Surface film;
  Eigen::AlignedBox3d box;
  for (const std::int32_t i : result.vertices) {
    film.positions.emplace_back(points[i][0], points[i][1], points[i][2]);
    film.site.push_back(i);
    box.extend(film.positions.back());
  }
  for (Vec3& p : film.positions) p = (p - box.min()) / box.sizes().maxCoeff();
  film.triangles.assign(result.triangles.begin(), result.triangles.end());
  return film;
}

// Sum over the edges of length times change of normal.
double bends(const Surface& film, const std::vector<Index>& twin) {
  std::vector<Vec3> normal;
  for (const Corners& c : film.triangles)
    normal.push_back((film.positions[c[1]] - film.positions[c[0]])
                         .cross(film.positions[c[2]] - film.positions[c[0]])
                         .normalized());
  double sum = 0;
  for (std::size_t h = 0; h < twin.size(); ++h)
    if (twin[h] > static_cast<Index>(h)) {
      const Corners& c = film.triangles[h / 3];
      sum += (film.positions[c[h % 3]] - film.positions[c[(h + 1) % 3]]).norm() *
             (normal[h / 3] - normal[twin[h] / 3]).norm();
    }
  return sum;
}

TEST(FeatureFlips, KeepTheVerticesAndTheTopology) {
  for (const auto& [name, points] : clouds()) {
    SCOPED_TRACE(name);
    const Result before = without_flips(points), after = reconstruct(points);
    ASSERT_EQ(before.status, Status::Ok);
    ASSERT_EQ(after.status, Status::Ok);
    EXPECT_EQ(before.report.flips, 0);
    EXPECT_EQ(after.report.flips == 0, name == "sphere");  // there is nothing to gain
    EXPECT_EQ(after.vertices, before.vertices);
    EXPECT_EQ(after.triangles.size(), before.triangles.size());
    EXPECT_EQ(after.report.genus, before.report.genus);
    EXPECT_EQ(after.report.components, before.report.components);
  }
}

TEST(FeatureFlips, LowerTheSumOfBendsAndKeepTheTwins) {
  for (const auto& [name, points] : clouds()) {
    SCOPED_TRACE(name);
    Surface film = film_of(without_flips(points), points);
    const auto vertices = static_cast<Index>(film.positions.size());
    std::vector<Index> twins = half_edge_twins(film.triangles, vertices);
    const double before = bends(film, twins);
    const std::int64_t flips = flip_to_features(film, twins);
    EXPECT_EQ(flips == 0, name == "sphere");
    EXPECT_TRUE(flips == 0 || bends(film, twins) < before);
    EXPECT_EQ(twins, half_edge_twins(film.triangles, vertices));
    EXPECT_TRUE(check_manifold(film.triangles, vertices).ok());
    EXPECT_TRUE(check_manifold_with_twins(film.triangles, vertices, twins).ok());
  }
}

TEST(FeatureFlips, AreTheSameForAnyNumberOfThreads) {
  const std::vector<Point> points = test::box(4000, 5, {1, 2, 1});
  const Surface film = film_of(without_flips(points), points);
  const std::vector<Index> twins = half_edge_twins(film.triangles, static_cast<Index>(film.positions.size()));
  std::vector<Corners> one;
  for (const std::size_t threads : {1, 2, 8}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    Surface flipped = film;
    std::vector<Index> flipped_twins = twins;
    flip_to_features(flipped, flipped_twins);
    if (one.empty()) one = flipped.triangles;
    EXPECT_EQ(flipped.triangles, one);
  }
}

TEST(FeatureFlips, AFilmWithABorderKeepsIt) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::vector<Point> points;
  for (int i = 0; i < 3000; ++i) {
    const double x = uniform(random), y = uniform(random);
    points.push_back({x, y, std::abs(x - 0.5)});  // a roof
  }
  Options options;
  options.open_boundary = true;
  const Result after = reconstruct(points, options);
  options.sharp_edges = false;
  const Result before = reconstruct(points, options);
  ASSERT_EQ(after.status, Status::Ok) << after.message;
  EXPECT_GT(after.report.flips, 0);
  EXPECT_GT(after.report.boundary_edges, 0);
  EXPECT_EQ(after.report.boundary_edges, before.report.boundary_edges);
  EXPECT_EQ(after.vertices, before.vertices);
}

// Points along the twelve edges of a box, and on its sides: all pieces of its edges are edges of the mesh.
TEST(FeatureFlips, TheEdgesOfABoxAreEdgesOfTheMesh) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(0.02, 0.98);
    constexpr int kPieces = 20;
    std::vector<Point> points;
    std::set<std::pair<int, int>> wanted;
    for (int axis = 0; axis < 3; ++axis)
      for (int corner = 0; corner < 4; ++corner)
        for (int i = 0, last = 0; i <= kPieces; ++i) {
          Point p;
          p[axis] = static_cast<double>(i) / kPieces;
          p[(axis + 1) % 3] = corner % 2, p[(axis + 2) % 3] = corner / 2;
          const auto found = std::find(points.begin(), points.end(), p);
          const int id = static_cast<int>(found - points.begin());
          if (found == points.end()) points.push_back(p);
          if (i > 0) wanted.insert(std::minmax(last, id));
          last = id;
        }
    for (int side = 0; side < 6; ++side)
      for (int i = 0; i < 400; ++i) {
        Point p;
        p[side % 3] = side / 3, p[(side + 1) % 3] = uniform(random), p[(side + 2) % 3] = uniform(random);
        points.push_back(p);
      }
    const Result result = reconstruct(points);
    ASSERT_EQ(result.status, Status::Ok);
    std::set<std::pair<int, int>> edges;
    for (const Triangle& t : result.triangles)
      for (int k = 0; k < 3; ++k)
        edges.insert(std::minmax(static_cast<int>(result.vertices[t[k]]),
                                 static_cast<int>(result.vertices[t[(k + 1) % 3]])));
    int missing = 0;
    for (const auto& e : wanted) missing += edges.count(e) == 0;
    EXPECT_EQ(missing, 0) << "of " << wanted.size() << ", seed " << seed;
  }
}

TEST(FeatureFlips, EndWhenAskedTo) {
  const std::vector<Point> points = test::box(2000, 3, {1, 1, 1});
  Surface film = film_of(without_flips(points), points);
  std::vector<Index> twins = half_edge_twins(film.triangles, static_cast<Index>(film.positions.size()));
  const std::atomic<bool> wish{true};
  EXPECT_THROW(flip_to_features(film, twins, Cancel{&wish}), Cancelled);
}

}  // namespace
}  // namespace filmsticking
