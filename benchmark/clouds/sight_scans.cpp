// SPDX-License-Identifier: GPL-3.0-or-later
#include "sight_scans.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "ray_scene.h"

namespace filmsticking::bench {
namespace {

Point point(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

double between(double low, double high, Random& random) { return low + (high - low) * random.uniform(); }

/// Adds what a scanner sees along the rays, up to `reach`.
void look(Scan& scan, const RayScene& scene, const Vec3& eye, const std::vector<Vec3>& rays, double reach,
          double deviation, Random& random) {
  for (const Vec3& ray : rays) {
    const double way = scene.first_hit(eye, ray);
    if (!(way < reach)) continue;
    scan.points.push_back(point(eye + (way + deviation * random.gauss()) * ray));
    scan.sensors.push_back(point(eye));
  }
}

/// Directions all around, evenly spread in a spiral.
std::vector<Vec3> all_around(int count, Random& random) {
  const double phase = random.uniform();
  std::vector<Vec3> rays;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count, angle = 2 * M_PI * (0.6180339887498949 * i + phase);
    rays.emplace_back(std::sqrt(1 - z * z) * std::cos(angle), std::sqrt(1 - z * z) * std::sin(angle), z);
  }
  return rays;
}

Box wider(Box box, double by) {
  box.low.head<2>().array() -= by;
  box.high.head<2>().array() += by;
  return box;
}

bool meet(const Box& a, const Box& b) {
  return (a.low.head<2>().array() < b.high.head<2>().array()).all() &&
         (b.low.head<2>().array() < a.high.head<2>().array()).all();
}

/// A place on the floor of a room, so far from its walls.
Vec3 on_floor(const Box& room, double from_walls, Random& random) {
  return {between(room.low.x() + from_walls, room.high.x() - from_walls, random),
          between(room.low.y() + from_walls, room.high.y() - from_walls, random), 0};
}

/// Cupboards that leave room for the stations, each other and a way along the walls.
void furnish(RayScene& scene, const std::vector<Vec3>& stations, std::size_t count, Random& random) {
  constexpr double kWay = 0.5, kTripod = 0.4;
  for (int tries = 0; scene.boxes.size() < count && tries < 1000; ++tries) {
    const Vec3 half(between(0.25, 0.6, random), between(0.25, 0.6, random), 0);
    const double height = between(0.5, 1.1, random);
    const Box& room = scene.rooms[random.below(scene.rooms.size())];
    const Vec3 middle = on_floor(room, 0.6 + kWay, random);
    const Box box = {middle - half, middle + half + Vec3(0, 0, height)};
    const auto too_near = [&](const Vec3& eye) {
      return wider(box, kTripod).contains({eye.x(), eye.y(), height / 2});
    };
    if (std::any_of(stations.begin(), stations.end(), too_near)) continue;
    if (std::any_of(scene.boxes.begin(), scene.boxes.end(),
                    [&](const Box& other) { return meet(wider(box, kWay), other); }))
      continue;
    scene.boxes.push_back(box);
  }
}

double volume_of(const Box& box) { return (box.high - box.low).prod(); }

/// From above, and nothing is known of the sides and the base.
void seen_from_above(Scan& scan, int holes) {
  constexpr int kCliffRims = 2;  // a cliff may break the surface at its foot
  scan.direction = Point{0, 0, -1};
  scan.least_used = 0.98;
  scan.least_front = 0.95;
  scan.most_borders = 1 + holes + kCliffRims;
  scan.main_share = 0.98;
}

}  // namespace

Scan make_room(Random& random, bool corner) {
  constexpr double kHeight = 2.6, kEyeLow = 1.2, kEyeHigh = 1.7;
  constexpr int kRays = 16000;
  const double x = between(5, 8, random), y = between(4, 6, random);
  RayScene scene;
  scene.rooms = {{{0, 0, 0}, {x, y, kHeight}}};
  if (corner)
    scene.rooms.push_back({{0, y, 0}, {between(2.5, 3.5, random), y + between(2.5, 4, random), kHeight}});
  const std::size_t count = 2 + random.below(3);
  std::vector<Vec3> stations;
  for (std::size_t i = 0; i < count; ++i) {
    stations.push_back(on_floor(scene.rooms[i % scene.rooms.size()], 0.8, random));
    stations.back().z() = between(kEyeLow, kEyeHigh, random);
  }
  furnish(scene, stations, 2 + random.below(3), random);
  const double deviation = between(0.002, 0.01, random);
  Scan scan;
  for (const Vec3& eye : stations)
    look(scan, scene, eye, all_around(kRays / static_cast<int>(count), random), INFINITY, deviation, random);
  scan.size = scene.rooms.size() > 1 ? std::max(x, scene.rooms[1].high.y()) : x;
  scan.least_used = 0.98;
  scan.main_share = 0.95;
  scan.least_front = 0.95;
  double volume = 0;
  for (const Box& room : scene.rooms) volume += volume_of(room);
  for (const Box& box : scene.boxes) volume -= volume_of(box);
  scan.volume = volume;
  scan.tolerance = 0.1;
  return scan;
}

Scan make_lidar(Random& random) {
  constexpr int kBeams = 32, kColumns = 900;
  constexpr double kLow = -30.67 * M_PI / 180, kHigh = 10.67 * M_PI / 180, kReach = 50, kNoise = 0.02;
  const Vec3 eye(0, 0, 1.8);
  RayScene scene;
  scene.ground = true;
  const auto place = [&](double near, double far) {
    const double angle = 2 * M_PI * random.uniform(), away = between(near, far, random);
    return Vec3(away * std::cos(angle), away * std::sin(angle), 0);
  };
  const auto add_box = [&](const Vec3& middle, Vec3 sides) {
    if (random.below(2) == 0) std::swap(sides.x(), sides.y());
    const Vec3 half(sides.x() / 2, sides.y() / 2, 0);
    const Box box = {middle - half, middle + half + Vec3(0, 0, sides.z())};
    if (!wider(box, 2).contains({0, 0, sides.z() / 2})) scene.boxes.push_back(box);
  };
  for (std::size_t i = 4 + random.below(4); i > 0; --i) add_box(place(5, 20), {4.2, 1.8, 1.5});  // cars
  for (std::size_t i = 2 + random.below(3); i > 0; --i)
    add_box(place(15, 35), {between(8, 20, random), between(0.3, 8, random), between(3, 8, random)});
  for (std::size_t i = 5 + random.below(6); i > 0; --i) {
    const Vec3 at = place(4, 20);
    scene.poles.push_back({at.x(), at.y(), between(0.08, 0.2, random), between(3, 7, random)});
  }
  std::vector<Vec3> rays;
  for (int beam = 0; beam < kBeams; ++beam) {
    const double up = kLow + (kHigh - kLow) * beam / (kBeams - 1), phase = random.uniform();
    for (int column = 0; column < kColumns; ++column) {
      const double around = 2 * M_PI * (column + phase) / kColumns;
      rays.emplace_back(std::cos(up) * std::cos(around), std::cos(up) * std::sin(around), std::sin(up));
    }
  }
  Scan scan;
  look(scan, scene, eye, rays, kReach, kNoise, random);
  scan.size = 2 * kReach;
  scan.least_used = 0.95;
  scan.least_front = 0.95;
  return scan;
}

Scan make_cliffs(Random& random) {
  constexpr int kColumns = 90, kRows = 70;
  constexpr double kEast = 483000, kNorth = 5457000;
  const double cell = between(0.5, 2, random), step = between(4, 12, random) * cell;
  const double at_x = between(30, 60, random), at_y = between(25, 45, random),
               slant = between(-0.3, 0.3, random);
  const double wave = between(0, 2 * M_PI, random);
  struct Hole {
    double x, y, a, b;
  };
  std::vector<Hole> holes;
  const std::size_t count = 2 + random.below(2);
  for (std::size_t i = 0; i < count; ++i)  // in columns of their own, away from the rim
    holes.push_back({between(10, 18, random) + 27 * static_cast<double>(i), between(12, kRows - 12, random),
                     between(4, 7, random), between(4, 7, random)});
  Scan scan;
  for (int j = 0; j < kRows; ++j)
    for (int i = 0; i < kColumns; ++i) {
      const auto in_hole = [&](const Hole& hole) {
        return std::hypot((i - hole.x) / hole.a, (j - hole.y) / hole.b) < 1;
      };
      if (std::any_of(holes.begin(), holes.end(), in_hole)) continue;
      double z = cell * (3 * std::sin(i / 17.0 + wave) + 2 * std::cos(j / 13.0));
      if (i > at_x + slant * j) z += step;
      if (j > at_y - slant * i) z += 0.7 * step;
      z += 0.05 * cell * random.gauss();
      scan.points.push_back({kEast + cell * i, kNorth + cell * j, 200 + z});
    }
  scan.size = cell * kColumns;
  seen_from_above(scan, static_cast<int>(count));
  return scan;
}

Scan make_sea_bed(Random& random) {
  constexpr int kPoints = 6000;
  constexpr double kEast = -4.5, kNorth = 48.3;
  const double side = between(0.01, 0.05, random), deep = between(15, 60, random);
  const double turn = between(0, M_PI, random), wave = between(0, 2 * M_PI, random);
  Scan scan;
  const int rows = static_cast<int>(std::sqrt(kPoints));
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < rows; ++i) {
      const double u = (i + 0.6 * random.uniform()) / rows, v = (j + 0.6 * random.uniform()) / rows;
      const double along = u * std::cos(turn) + v * std::sin(turn);
      const double z = -deep * (1 + 0.3 * std::sin(5 * along + wave) + 0.2 * u * v) + 0.1 * random.gauss();
      scan.points.push_back({kEast + side * u, kNorth + side * v, z});
    }
  scan.size = deep;
  seen_from_above(scan, 0);
  return scan;
}

}  // namespace filmsticking::bench
