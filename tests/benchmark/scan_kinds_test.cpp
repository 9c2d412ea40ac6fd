// SPDX-License-Identifier: GPL-3.0-or-later
// The scans whose right answer is known, and how their meshes are judged.
#include "clouds/scan_kinds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "clouds/ray_scene.h"
#include "clouds/shapes.h"
#include "compare/occupancy.h"
#include "compare/scan_result.h"
#include "compare/scan_table.h"

namespace filmsticking::bench {
namespace {

double norm(const Point& p) { return std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]); }

double distance(const Point& a, const Point& b) { return norm({a[0] - b[0], a[1] - b[1], a[2] - b[2]}); }

TEST(ScanKinds, SameSeedSameScanOtherSeedOtherScan) {
  for (const ScanKind& kind : scan_kinds()) {
    const Scan scan = make_scan(kind.name, 3), again = make_scan(kind.name, 3);
    EXPECT_EQ(scan.points, again.points) << kind.name;
    EXPECT_EQ(scan.needed, again.needed) << kind.name;
    EXPECT_NE(scan.points, make_scan(kind.name, 4).points) << kind.name;
    for (const Point& p : scan.points) ASSERT_TRUE(std::isfinite(norm(p))) << kind.name;
  }
  EXPECT_THROW(make_scan("magic", 1), std::invalid_argument);
}

TEST(ScanKinds, HaveTheirNumbersOfPoints) {
  struct Known {
    const char* kind;
    std::size_t least, most;
  };
  for (const Known& known : {Known{"bottomless_sphere", 3000, 12000},
                             {"bottomless_box", 3000, 12000},
                             {"bottomless_vase", 3000, 12000},
                             {"tube", 3000, 12000},
                             {"slices", 3000, 9000},
                             {"rings", 16 * 360, 16 * 360},
                             {"figure", 9700, 10300},
                             {"tool", 8005, 8005},
                             {"volume", 6000, 6000},
                             {"corners", 600, 4000},
                             {"far_few", 10010, 10010},
                             {"room", 15990, 16000},
                             {"corner", 15990, 16000},
                             {"lidar", 15000, 32 * 900},
                             {"cliffs", 5600, 6300},
                             {"sea_bed", 5929, 5929}})
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const std::size_t count = make_scan(known.kind, seed).points.size();
      EXPECT_GE(count, known.least) << known.kind;
      EXPECT_LE(count, known.most) << known.kind;
    }
}

TEST(ScanKinds, VolumesAreThoseOfTheSolids) {
  EXPECT_NEAR(*make_scan("bottomless_sphere", 1).volume, 9.0 / 8 * M_PI, 1e-12);
  EXPECT_NEAR(*make_scan("bottomless_box", 1).volume, 0.4 * 0.3 * 0.25, 1e-12);
  EXPECT_NEAR(*make_scan("tube", 1).volume, 4 * M_PI, 1e-12);
  EXPECT_NEAR(*make_scan("rings", 1).volume, 180, 1e-12);
  EXPECT_NEAR(*make_scan("corners", 1).volume, 60000, 1e-9);
  // The others by the areas of thin layers.
  constexpr int kLayers = 100000;
  double vase = 0, torso = 0;
  for (int i = 0; i < kLayers; ++i) {
    const double t = (i + 0.5) / kLayers, u = 2 * t - 1;
    const double r = 0.75 + 0.35 * std::cos(M_PI * (3 * t - 1) / 2);
    vase += M_PI * r * r * 3 / kLayers;
    const double mean = 0.7 * std::sqrt(1 - u * u) * (1 + 0.15 * u);
    torso += M_PI * mean * mean * (1 + 0.3 * 0.3 / 2) * 2.4 / kLayers;
  }
  EXPECT_NEAR(*make_scan("bottomless_vase", 1).volume, vase, 1e-6);
  EXPECT_NEAR(*make_scan("slices", 1).volume, torso, 1e-6);
}

TEST(ScanKinds, AreasAreThoseOfTheParts) {
  // The handle without its end in the blade, and the blade without its end in the handle.
  const double handle = 2 * M_PI * 12 * 66 + 4 * M_PI * 12 * 12, blade = 2 * (25 * 3 + 120 * 25 + 120 * 3);
  const double tool = *make_scan("tool", 1).area;
  EXPECT_LT(tool, handle + blade);
  EXPECT_GT(tool, 0.94 * (handle + blade));
  const auto capsule = [](double length, double r) { return 2 * M_PI * r * length + 4 * M_PI * r * r; };
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const double figure = *make_scan("figure", seed).area;
    // The torso, the head, limbs of lengths 0.55 to 0.61 and 0.87 to 0.92; a sixth at most is within others.
    EXPECT_LT(figure, capsule(0.36, 0.16) + capsule(0.2, 0.06) + capsule(0.06, 0.12) +
                          2 * capsule(0.62, 0.045) + 2 * capsule(0.93, 0.07));
    EXPECT_GT(figure, 5.0 / 6 *
                          (capsule(0.36, 0.16) + capsule(0.06, 0.12) + 2 * capsule(0.55, 0.045) +
                           2 * capsule(0.86, 0.07)));
  }
}

TEST(ScanKinds, PointsLieOnTheirSurfacesButForNoise) {
  // Rotations keep the distance from the origin.
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Scan sphere = make_scan("bottomless_sphere", seed);
    const double spacing = std::sqrt(3 * M_PI / static_cast<double>(sphere.points.size()));
    double squares = 0;
    for (const Point& p : sphere.points) squares += (norm(p) - 1) * (norm(p) - 1);
    EXPECT_NEAR(std::sqrt(squares / static_cast<double>(sphere.points.size())), 0.18 * spacing,
                0.01 * spacing);
    double lowest = 9, farthest = 0;
    for (const Point& p : make_scan("rings", seed).points) {
      lowest = std::min(lowest, norm(p));
      farthest = std::max(farthest, norm(p));
    }
    EXPECT_GT(lowest, 1.5 * std::sqrt(2) - 0.1);  // the rings nearest to the middles of floor and ceiling
    EXPECT_LT(farthest, std::sqrt(25 + 9 + 2.25) + 0.1);
    for (const Point& p : make_scan("volume", seed).points) EXPECT_LE(norm(p), 1 + 1e-12);
  }
}

TEST(ScanKinds, StraysAreFarAway) {
  const Scan tool = make_scan("tool", 2);
  // A stray has no point within one and a half of the tool's lengths, but for other strays.
  int strays = 0;
  for (const Point& p : tool.points)
    strays += std::count_if(tool.points.begin(), tool.points.end(),
                            [&](const Point& q) { return distance(p, q) < 1.4 * 200; }) < 10
                  ? 1
                  : 0;
  EXPECT_EQ(strays, 5);
}

TEST(ScanKinds, NothingStandsBetweenAPointAndItsSensor) {
  RayScene scene;
  scene.rooms = {{{0, 0, 0}, {4, 4, 3}}, {{4, 0, 0}, {6, 1, 3}}};
  scene.boxes = {{{1, 2, 0}, {2, 3, 1}}};
  scene.poles = {{3, 3, 0.1, 2}};
  EXPECT_NEAR(scene.first_hit({0.5, 2.5, 0.5}, {1, 0, 0}), 0.5, 1e-12);  // the box
  EXPECT_NEAR(scene.first_hit({0.5, 2.5, 1.5}, {1, 0, 0}), 3.5, 1e-12);  // the wall over it
  EXPECT_NEAR(scene.first_hit({0.5, 0.5, 1.5}, {1, 0, 0}), 5.5, 1e-12);  // the wall of the other room
  EXPECT_NEAR(scene.first_hit({2.5, 3, 1.5}, {1, 0, 0}), 0.4, 1e-12);    // the pole
  EXPECT_NEAR(scene.first_hit({2.5, 3, 2.5}, {1, 0, 0}), 1.5, 1e-12);    // over it
  scene.rooms.clear();
  EXPECT_EQ(scene.first_hit({0.5, 2.5, 1.5}, {-1, 0, 0}), INFINITY);
  scene.ground = true;
  EXPECT_NEAR(scene.first_hit({0.5, 2.5, 1.5}, {0, 0, -1}), 1.5, 1e-12);
}

TEST(ScanKinds, SensorsAreThoseOfTheirPoints) {
  for (const char* kind : {"room", "corner", "lidar"}) {
    const Scan scan = make_scan(kind, 7);
    ASSERT_EQ(scan.sensors.size(), scan.points.size()) << kind;
    std::map<Point, std::set<Point>> directions;
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
      const double way = distance(scan.points[i], scan.sensors[i]);
      directions[scan.sensors[i]].insert({std::round(1e4 * (scan.points[i][0] - scan.sensors[i][0]) / way),
                                          std::round(1e4 * (scan.points[i][1] - scan.sensors[i][1]) / way),
                                          std::round(1e4 * (scan.points[i][2] - scan.sensors[i][2]) / way)});
    }
    EXPECT_LE(directions.size(), 4U) << kind;
    // Each of a scanner's rays has one hit; points of other sensors would share directions by chance.
    std::size_t rays = 0;
    for (const auto& [sensor, of] : directions) rays += of.size();
    EXPECT_GT(rays, scan.points.size() * 999 / 1000) << kind;
  }
  EXPECT_EQ(make_scan("cliffs", 1).direction, (Point{0, 0, -1}));
}

TEST(ScanResults, BordersFrontsAndUsedPointsAreCounted) {
  Mesh mesh = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {9, 9, 9}},
               {{0, 1, 2}, {0, 2, 3}, {4, 6, 5}}};
  Scan scan;
  scan.size = 6;
  scan.points = mesh.positions;
  scan.direction = Point{0, 0, -2};
  ScanMeasures found = measure_scan(mesh, scan);
  EXPECT_EQ(found.borders, 2);
  EXPECT_EQ(found.used, 7.0 / 8);
  EXPECT_NEAR(*found.front, 2.0 / 3, 1e-12);  // the third triangle looks down
  scan.direction.reset();
  scan.sensors.assign(4, Point{0, 0, -3});  // the square was seen from below
  scan.sensors.resize(8, Point{NAN, NAN, NAN});
  for (std::size_t i = 4; i < 8; ++i) scan.sensors[i] = {0, 0, -3};
  found = measure_scan(mesh, scan);
  EXPECT_NEAR(*found.front, 1.0 / 3, 1e-12);
  scan.sensors.clear();
  EXPECT_FALSE(measure_scan(mesh, scan).front);
}

TEST(ScanResults, FaultsOfSeenSurfacesAreNamed) {
  Scan scan;
  scan.size = 1;
  scan.least_used = 0.9;
  scan.most_borders = 2;
  scan.least_front = 0.95;
  const auto fault = [&](double used, int borders, double front) {
    ScanResult result;
    result.row.set("status", "ok");
    ScanMeasures measures;
    measures.used = used, measures.borders = borders, measures.front = front;
    judge_scan(result, scan, &measures);
    return result.wrong;
  };
  EXPECT_EQ(fault(0.95, 2, 0.99), "");
  EXPECT_EQ(fault(0.85, 2, 0.99), "0.850 of the points used");
  EXPECT_EQ(fault(0.95, 3, 0.99), "3 borders");
  EXPECT_EQ(fault(0.95, 2, 0.1), "front on 0.100");
}

TEST(Occupancy, OverlapsAreThoseOfTheSolids) {
  const Mesh slab = make_shape("slab:1", 400);  // 1 by 1
  double thick = 0, low = 9;
  for (const Point& p : slab.positions) thick = std::max(thick, p[2]), low = std::min(low, p[2]);
  std::vector<Probe> probes;  // of a slab of twice the width
  for (int i = -30; i < 60; ++i)
    for (int k = -4; k < 8; ++k) {
      const double x = (i + 0.5) / 30, z = low + (k + 0.5) / 4 * (thick - low);
      probes.push_back({{x, 0.5, z}, x > 0 && x < 2 && k >= 0 && k < 4});
    }
  const auto half = overlap(slab, probes);
  ASSERT_TRUE(half);
  EXPECT_NEAR(half->iou, 0.5, 1e-12);
  EXPECT_NEAR(half->missing, 0.5, 1e-12);
  EXPECT_EQ(half->extra, 0);
  Mesh open = slab;
  open.triangles.pop_back();
  EXPECT_FALSE(overlap(open, probes));
  EXPECT_FALSE(overlap({}, probes));
}

TEST(ScanKinds, NeededPointsAreAmongThePoints) {
  for (const char* kind : {"corners", "far_few"}) {
    const Scan scan = make_scan(kind, 5);
    const std::set<Point> points(scan.points.begin(), scan.points.end());
    EXPECT_EQ(scan.needed.size(), kind == std::string("corners") ? 8U : 10U);
    EXPECT_EQ(scan.least_needed, 8U);
    for (const Point& p : scan.needed) EXPECT_EQ(points.count(p), 1U) << kind;
  }
}

TEST(ScanResults, MeasuresAreThoseOfTheMesh) {
  Mesh mesh = make_shape("slab:1", 60);  // a plate of 1 by 1
  double thickness = 0;
  for (const Point& p : mesh.positions) thickness = std::max(thickness, p[2]);
  Scan scan;
  scan.size = 1;
  scan.needed = {mesh.positions.front(), {9, 9, 9}};
  const ScanMeasures plate = measure_scan(mesh, scan);
  EXPECT_NEAR(plate.volume, thickness, 1e-9);
  EXPECT_NEAR(plate.area, 2 + 4 * thickness, 1e-9);
  EXPECT_EQ(plate.main_share, 1);
  EXPECT_EQ(plate.needed, 1);
  const auto n = static_cast<std::int32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), {{10, 0, 0}, {13, 0, 0}, {10, 4, 0}});
  mesh.triangles.push_back({n, n + 1, n + 2});
  const ScanMeasures more = measure_scan(mesh, scan);
  EXPECT_NEAR(more.longest_edge, 5, 1e-9);
  EXPECT_NEAR(more.main_share, 6 / (6 + plate.area), 1e-9);
}

TEST(ScanResults, TheFirstFaultIsNamed) {
  Scan scan;
  scan.size = 2;
  scan.volume = 4;
  scan.tolerance = 0.1;
  scan.closed = scan.one_piece = scan.genus_zero = true;
  scan.longest_edge = 0.5;
  const auto fault = [&](const char* column, const char* text, double volume, double longest) {
    ScanResult result;
    for (const char* yes : {"closed", "oriented"}) result.row.set(yes, "true");
    result.row.set("status", "ok");
    result.row.set("components", "1");
    result.row.set("genus", "0");
    if (*column) result.row.set(column, text);
    const ScanMeasures measures{volume, 9, longest, 1, 0, 0, 1, {}};
    judge_scan(result, scan, &measures);
    return result.wrong;
  };
  EXPECT_EQ(fault("", "", 4.3, 0.9), "");
  EXPECT_EQ(fault("", "", 4.5, 0.9), "volume 1.12 of the truth");
  EXPECT_EQ(fault("", "", -4, 0.9), "volume -1.00 of the truth");
  EXPECT_EQ(fault("", "", 4, 1.1), "an edge of 0.550 sizes");
  EXPECT_EQ(fault("closed", "false", 4, 0.9), "not closed");
  EXPECT_EQ(fault("components", "2", 4, 0.9), "2 components");
  EXPECT_EQ(fault("genus", "3", 4, 0.9), "genus 3");
  EXPECT_EQ(fault("status", "crashed", 4, 0.9), "crashed");
  scan.no_surface = true;
  EXPECT_EQ(fault("", "", 4, 0.9), "no warning");
  EXPECT_EQ(fault("message", "They fill a volume.", 4, 0.9), "");
}

TEST(ScanResults, TheTableHasARowForEachKind) {
  std::vector<ScanResult> results(3);
  for (std::size_t i = 0; i < 3; ++i) {
    results[i].kind = i < 2 ? "tube" : "rings";
    results[i].method = "ours";
    results[i].seed = i + 1;
    results[i].over_truth = 0.9 + 0.1 * static_cast<double>(i);
    results[i].longest_edge = 0.25 * static_cast<double>(i);
    results[i].row.set("seconds", 2);
  }
  results[1].wrong = "genus 1";
  const std::string text = scan_tables(results);
  EXPECT_NE(text.find("| tube | 1 of 2 | 0.950 | 0.250 | - | - | 2.00 | - |\n"
                      "| rings | 1 of 1 | 1.10 | 0.500 | - | - | 2.00 | - |"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("- tube, seed 2: genus 1\n"), std::string::npos) << text;
}

}  // namespace
}  // namespace filmsticking::bench
