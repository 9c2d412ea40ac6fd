// SPDX-License-Identifier: GPL-3.0-or-later
// --ground: volumes of things that stand on a plane, within 1 % of what they were generated with.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "filters/filter_error.h"
#include "filters/on_ground.h"
#include "io/formats.h"
#include "support/model.h"
#include "support/run_program.h"
#include "support/scratch_folder.h"

namespace filmsticking::test {
namespace {

using Json = nlohmann::json;
using filters::GroundChoice;
using filters::GroundPlane;

class Sampler {
 public:
  explicit Sampler(double noise = 0) : noise_(noise) {}
  double uniform(double least, double most) {
    return least + (most - least) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  void add(double x, double y, double z) {
    const auto jitter = [&] {
      double sum = -6;
      for (int i = 0; i < 12; ++i) sum += uniform(0, 1);
      return noise_ * sum;
    };
    points.push_back({x + jitter(), y + jitter(), z + jitter()});
  }
  std::vector<Point> points;

 private:
  std::mt19937_64 engine_{7};
  double noise_;
};

/// Somewhere in space, where the plane is no axis'.
std::vector<Point> tilted(std::vector<Point> points) {
  const Eigen::AngleAxisd turn(0.4, Eigen::Vector3d(1, 2, 0).normalized());
  for (Point& p : points) {
    const Eigen::Vector3d q = turn * Eigen::Vector3d(p[0], p[1], p[2]) + Eigen::Vector3d(3, -8, 20);
    p = {q.x(), q.y(), q.z()};
  }
  return points;
}

/// A heap of this height as a function of the distance from its middle, on a square of ground.
std::vector<Point> heap(const std::function<double(double)>& height, double noise) {
  Sampler sampler(noise);
  for (int i = 0; i < 20'000; ++i) {
    const double x = sampler.uniform(-2, 2), y = sampler.uniform(-2, 2), r = std::hypot(x, y);
    sampler.add(x, y, r < 1 ? height(r) : 0);
  }
  return sampler.points;
}

double round_heap(double r) { return 0.25 * (1 + std::cos(M_PI * r)); }
constexpr double kRoundVolume = M_PI * (0.25 - 1 / (M_PI * M_PI));

/// A box of 1 x 0.6 x 0.4: five sides of it and the table around.
std::vector<Point> box_on_table(double noise) {
  Sampler sampler(noise);
  const auto side = [&](int count, const Point& corner, const Point& u, const Point& v) {
    for (int i = 0; i < count; ++i) {
      const double s = sampler.uniform(0, 1), t = sampler.uniform(0, 1);
      sampler.add(corner[0] + s * u[0] + t * v[0], corner[1] + s * u[1] + t * v[1],
                  corner[2] + s * u[2] + t * v[2]);
    }
  };
  constexpr int kDensity = 1200;
  side(kDensity * 6 / 10, {0, 0, 0.4}, {1, 0, 0}, {0, 0.6, 0});
  for (const double y : {0.0, 0.6}) side(kDensity * 4 / 10, {0, y, 0}, {1, 0, 0}, {0, 0, 0.4});
  for (const double x : {0.0, 1.0}) side(kDensity * 24 / 100, {x, 0, 0}, {0, 0.6, 0}, {0, 0, 0.4});
  for (int i = 0; i < kDensity * 9; ++i) {
    const double x = sampler.uniform(-1, 2), y = sampler.uniform(-1.2, 1.8);
    if (x < 0 || x > 1 || y < 0 || y > 0.6) sampler.add(x, y, 0);
  }
  return sampler.points;
}

/// A bottle in pixels from above: neither the sides of its body nor those of its neck are seen.
std::vector<Point> bottle_from_above(double noise) {
  Sampler sampler(noise);
  for (double x = -6.03; x < 6; x += 0.1)
    for (double y = -6.06; y < 6; y += 0.1) {
      const double r = std::hypot(x, y);
      sampler.add(x, y, r < 1.4 ? 22 : r < 3.5 ? 15 + 4 * (3.5 - r) / 2.1 : 0);
    }
  return sampler.points;
}
constexpr double kBottleVolume =
    M_PI * (3.5 * 3.5 * 15 + 4. / 3 * (3.5 * 3.5 + 3.5 * 1.4 + 1.4 * 1.4) + 1.4 * 1.4 * 3);

class Ground : public ::testing::Test {
 protected:
  Json measure(const std::vector<Point>& points, std::vector<std::string> plane = {}) {
    io::write_mesh(folder / "cloud.ply", Model{points, {}, {}});
    std::vector<std::string> command = {PCD_TO_MESH, folder / "cloud.ply", folder / "mesh.ply",
                                        "--report",  folder / "run.json",  "--ground"};
    command.insert(command.end(), plane.begin(), plane.end());
    const Outcome made = run_program(command);
    EXPECT_EQ(made.status, 0) << made.err;
    EXPECT_NE(made.out.find("ground  "), std::string::npos) << made.out;
    const Outcome outcome = run_program({MESH_REPORT, folder / "mesh.ply", "--json"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const Json json = Json::parse(outcome.out);
    EXPECT_TRUE(json.at("closed").get<bool>());
    EXPECT_TRUE(json.at("manifold").get<bool>());
    EXPECT_TRUE(json.at("outward").get<bool>());
    return json;
  }

  double volume(const std::vector<Point>& points) { return measure(points).at("volume").get<double>(); }

  const ScratchFolder folder;
};

TEST_F(Ground, OfAHeapGivesItsVolume) {
  for (const double noise : {0.0, 0.004})
    EXPECT_NEAR(volume(tilted(heap(round_heap, noise))) / kRoundVolume, 1, 0.01) << noise;
  EXPECT_NEAR(volume(heap([](double r) { return 0.6 * (1 - r); }, 0)) / (0.6 * M_PI / 3), 1, 0.01);
}

TEST_F(Ground, OfABoxOnATableGivesItsVolume) {
  for (const double noise : {0.0, 0.003}) {
    const Json json = measure(tilted(box_on_table(noise)));
    EXPECT_NEAR(json.at("volume").get<double>() / 0.24, 1, 0.01) << noise;
    EXPECT_EQ(json.at("components").get<int>(), 1);
    EXPECT_EQ(json.at("genus").get<int>(), 0);
  }
}

TEST_F(Ground, OfABottleFromAboveGivesItsVolume) {
  for (const double noise : {0.0, 0.02})
    EXPECT_NEAR(volume(tilted(bottle_from_above(noise))) / kBottleVolume, 1, 0.01) << noise;
}

TEST_F(Ground, MayBeGiven) {
  std::vector<Point> above = heap(round_heap, 0);  // a scan whose ground was cut away
  above.erase(std::remove_if(above.begin(), above.end(), [](const Point& p) { return p[2] <= 0; }),
              above.end());
  EXPECT_NEAR(measure(above, {"0,0,2,0"}).at("volume").get<double>() / kRoundVolume, 1, 0.01);
  const Json run = Json::parse(std::string(run_program({"/bin/cat", folder / "run.json"}).out));
  EXPECT_EQ(run.at("ground").get<std::vector<double>>(), (std::vector<double>{0, 0, 1, 0}));
  EXPECT_GT(run.at("added").get<int>(), 100);
}

TEST_F(Ground, VolumeIsThatBetweenTheOpenSurfaceAndThePlane) {
  io::write_mesh(folder / "cloud.ply", Model{tilted(heap(round_heap, 0)), {}, {}});
  ASSERT_EQ(run_program({PCD_TO_MESH, folder / "cloud.ply", folder / "open.ply", "--open"}).status, 0);
  const Outcome outcome = run_program({MESH_REPORT, folder / "open.ply", "--json", "--ground"});
  const Json json = Json::parse(outcome.out);
  EXPECT_NEAR(json.at("volume_net").get<double>() / kRoundVolume, 1, 0.01);
}

TEST(OnGround, KeepsPointsWholeAndAddsTheLast) {
  pcl::PolygonMesh mesh = Model{box_on_table(0), {}, {}};
  const filters::OnGround standing = filters::on_ground(mesh.cloud, {true, std::nullopt});
  const std::vector<Point> before = io::positions_of(mesh.cloud), after = io::positions_of(standing.points);
  EXPECT_EQ(after.size() + static_cast<std::size_t>(standing.on_plane - standing.added), before.size());
  std::size_t at = 0;
  const std::size_t kept = after.size() - static_cast<std::size_t>(standing.added);
  for (std::size_t i = 0; i < kept; ++i) {
    while (at < before.size() && before[at] != after[i]) ++at;
    ASSERT_LT(at, before.size()) << "point " << i << " is none of the input, or not in its order";
  }
  for (std::size_t i = kept; i < after.size(); ++i)
    ASSERT_TRUE(after[i][2] > -1e-6 && after[i][2] < 0.4)
        << "point " << i << " is not on the box or under it";
}

TEST(OnGround, LeavesAloneWhatIsSeenToHangOverGround) {
  // A table top on one leg in the middle, and the floor below it.
  Sampler sampler;
  for (int i = 0; i < 30'000; ++i) {
    const double x = sampler.uniform(-2, 2), y = sampler.uniform(-2, 2), r = std::hypot(x, y);
    if (r > 0.2) sampler.add(x, y, 0);
    if (r < 1) sampler.add(x, y, 1);
    if (r < 1 && r > 0.2) sampler.add(x, y, 0.9);
    const double angle = sampler.uniform(0, 2 * M_PI);
    if (i % 5 == 0) sampler.add(0.2 * std::cos(angle), 0.2 * std::sin(angle), sampler.uniform(0, 0.9));
  }
  const pcl::PolygonMesh mesh = Model{sampler.points, {}, {}};
  const filters::OnGround standing = filters::on_ground(mesh.cloud, {true, std::nullopt});
  const std::vector<Point> after = io::positions_of(standing.points);
  std::size_t top = 0;
  for (const Point& p : after) top += p[2] > 0.95 ? 1 : 0;
  EXPECT_GT(top, 5000u);  // the top is kept
  for (std::size_t i = after.size() - static_cast<std::size_t>(standing.added); i < after.size(); ++i)
    EXPECT_LT(std::hypot(after[i][0], after[i][1]), 0.3) << "nothing is added below the top";
}

TEST(OnGround, RefusesWhatHasNoGround) {
  const auto refused = [](const std::vector<Point>& points, const GroundChoice& choice) {
    const pcl::PolygonMesh mesh = Model{points, {}, {}};
    EXPECT_THROW(filters::on_ground(mesh.cloud, choice), filters::FilterError);
  };
  refused({}, {true, std::nullopt});
  refused({{1, 2, 3}, {1, 2, 3}}, {true, std::nullopt});
  refused({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {true, std::nullopt});  // nothing above
  refused(box_on_table(0), {true, GroundPlane{Eigen::Vector3d::UnitZ(), -9}});
  Sampler ball;
  while (ball.points.size() < 20'000) {
    const Eigen::Vector3d p(ball.uniform(-1, 1), ball.uniform(-1, 1), ball.uniform(-1, 1));
    if (p.norm() < 1) ball.add(p.x() / p.norm(), p.y() / p.norm(), p.z() / p.norm());
  }
  EXPECT_THROW(filters::find_ground(ball.points), filters::FilterError);
  std::vector<Point> far = box_on_table(0);
  far.push_back({1e12, 0, 5});
  far.push_back({NAN, 0, 5});
  refused(far, {true, GroundPlane{}});
  std::vector<Point> high = box_on_table(0);  // a column of points to it would never end
  for (int i = 0; i < 40; ++i) high.push_back({1.5 + 0.02 * (i % 8), 1 + 0.02 * (i / 8), 1e9});
  refused(high, {true, GroundPlane{}});
}

TEST(OnGround, RepeatedPointsChangeNoSpacing) {
  const std::vector<Point> once = box_on_table(0);
  std::vector<Point> often;
  for (int i = 0; i < 12; ++i) often.insert(often.end(), once.begin(), once.end());
  EXPECT_NEAR(filters::usual_distance(often) / filters::usual_distance(once), 1, 0.05);
}

TEST(OnGround, IsTheSameEachTime) {
  const pcl::PolygonMesh mesh = Model{tilted(box_on_table(0.003)), {}, {}};
  const filters::OnGround one = filters::on_ground(mesh.cloud, {true, std::nullopt});
  const filters::OnGround two = filters::on_ground(mesh.cloud, {true, std::nullopt});
  EXPECT_EQ(one.points.data, two.points.data);
}

TEST(GroundProgram, SaysWhatIsWrong) {
  const ScratchFolder folder;
  const auto fails = [&](std::vector<std::string> more, int status, const char* said) {
    more.insert(more.begin(), {PCD_TO_MESH, TEST_DATA "/bun0.pcd", folder / "mesh.ply"});
    const Outcome outcome = run_program(more);
    EXPECT_EQ(outcome.status, status);
    EXPECT_NE(outcome.err.find(said), std::string::npos) << outcome.err;
  };
  fails({"--ground", "--open"}, 2, "--ground closes the surface");
  fails({"--ground", "1,2,3"}, 2, "--ground takes A,B,C,D");
  fails({"--ground=0,0,0,1"}, 2, "--ground takes A,B,C,D");
  fails({"--ground", "0,0,1,-5"}, 1, "nothing stands on the plane");
}

}  // namespace
}  // namespace filmsticking::test
