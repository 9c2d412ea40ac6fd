// SPDX-License-Identifier: GPL-3.0-or-later
#include "scan_kinds.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <functional>
#include <numeric>
#include <stdexcept>

#include "capsule.h"
#include "level_surface.h"
#include "random.h"
#include "sensor_scans.h"
#include "sight_scans.h"
#include "surface_sampler.h"

namespace filmsticking::bench {
namespace {

Point point(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

Vec3 noisy(Vec3 p, double deviation, Random& random) {
  for (double& x : p) x += deviation * random.gauss();
  return p;
}

Vec3 random_direction(Random& random) { return noisy(Vec3::Zero(), 1, random).normalized(); }

/// A surface that is open, and the volume behind its lids.
Scan scan_without_lids(const Mesh& surface, double size, double volume, Random& random) {
  constexpr std::size_t kLeast = 3000, kMost = 12000;
  constexpr double kNoise = 0.18;  // in spacings
  const SurfaceSampler sampler(surface);
  const std::size_t count = kLeast + random.below(kMost - kLeast + 1);
  const double spacing = std::sqrt(sampler.area() / static_cast<double>(count));
  Scan scan;
  for (std::size_t i = 0; i < count; ++i)
    scan.points.push_back(point(noisy(sampler.draw(random).position, kNoise * spacing, random)));
  scan.size = size;
  scan.volume = volume;
  scan.tolerance = 0.1;
  scan.closed = scan.one_piece = scan.genus_zero = true;
  return scan;
}

/// A radius and a height for each t from 0 to 1.
using Profile = std::function<std::pair<double, double>(double)>;

/// A surface of revolution without lids.
Mesh revolve(const Profile& profile) {
  constexpr int kAround = 256, kAlong = 256;
  Mesh mesh;
  for (int i = 0; i <= kAlong; ++i) {
    const auto [r, z] = profile(static_cast<double>(i) / kAlong);
    for (int j = 0; j < kAround; ++j) {
      const double angle = 2 * M_PI * j / kAround;
      mesh.positions.push_back({r * std::cos(angle), r * std::sin(angle), z});
    }
  }
  const auto at = [](int i, int j) { return i * kAround + j % kAround; };
  for (int i = 0; i < kAlong; ++i)
    for (int j = 0; j < kAround; ++j) {
      mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
    }
  return mesh;
}

Scan make_bottomless_sphere(Random& random) {
  constexpr double kHeight = 1.5;  // of the part that is left of radius 1
  const double opening = std::acos(1 - kHeight);
  const Mesh surface =
      revolve([&](double t) { return std::make_pair(std::sin(t * opening), std::cos(t * opening)); });
  return scan_without_lids(surface, 2, M_PI * kHeight * kHeight * (3 - kHeight) / 3, random);
}

Scan make_bottomless_box(Random& random) {
  const Vec3 sides(0.4, 0.3, 0.25);
  Mesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.positions.push_back({i & 1 ? sides.x() : 0, i & 2 ? sides.y() : 0, i & 4 ? sides.z() : 0});
  mesh.triangles = {{4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4}, {1, 3, 7},
                    {1, 7, 5}, {3, 2, 6}, {3, 6, 7}, {2, 0, 4}, {2, 4, 6}};
  return scan_without_lids(mesh, sides.maxCoeff(), sides.prod(), random);
}

Scan make_bottomless_vase(Random& random) {
  // The radius is kMean + kWave cos(pi (z - 1) / 2): 0.75 at the foot, 1.1 at the belly, 0.4 at the mouth.
  constexpr double kHeight = 3, kMean = 0.75, kWave = 0.35;
  const Mesh surface = revolve([&](double t) {
    const double z = kHeight * t;
    return std::make_pair(kMean + kWave * std::cos(M_PI * (z - 1) / 2), z);
  });
  const double volume = M_PI * (3 * kMean * kMean + 4 / M_PI * kMean * kWave + 1.5 * kWave * kWave);
  return scan_without_lids(surface, kHeight, volume, random);
}

Scan make_tube(Random& random) {
  constexpr double kLength = 4;
  const Mesh surface = revolve([&](double t) { return std::make_pair(1.0, kLength * t); });
  return scan_without_lids(surface, kLength, M_PI * kLength, random);
}

/// In mm: a handle of 90, and a blade that reaches to 200.
Scan make_tool(Random& random) {
  constexpr std::size_t kPoints = 8000;
  constexpr int kStrays = 5;
  constexpr double kLength = 200, kNoise = 0.1, kCell = 0.5;
  const Capsule handle{{12, 0, 0}, {78, 0, 0}, 12};
  const Vec3 middle(140, 0, 0), half_sides(60, 12.5, 1.5);
  const Field field = [&](const Vec3& p) {
    const Vec3 beyond = (p - middle).cwiseAbs() - half_sides;
    const double blade = beyond.cwiseMax(0).norm() + std::min(beyond.maxCoeff(), 0.0);
    return std::min(handle.distance(p), blade);
  };
  const Mesh surface = make_level_surface(field, {-2.2, -14.7, -14.2}, {202, 14.7, 14.2}, kCell);
  const SurfaceSampler sampler(surface);
  Scan scan;
  for (std::size_t i = 0; i < kPoints; ++i)
    scan.points.push_back(point(noisy(sampler.draw(random).position, kNoise, random)));
  for (int i = 0; i < kStrays; ++i) {
    const double away = kLength * (2 + 3 * random.uniform());
    scan.points.push_back(point(Vec3(kLength / 2, 0, 0) + away * random_direction(random)));
  }
  scan.size = kLength;
  scan.area = sampler.area();
  scan.tolerance = 0.15;
  scan.longest_edge = 0.5;
  return scan;
}

Scan make_volume(Random& random) {
  constexpr int kPoints = 6000;
  Scan scan;
  for (int i = 0; i < kPoints; ++i) {
    const double radius = std::cbrt(random.uniform());
    scan.points.push_back(point(radius * random_direction(random)));
  }
  scan.size = 2;
  scan.no_surface = true;
  return scan;
}

/// A plate of 100 by 60 by 10. The grid is 2 to 5 wide, the corners are exact, the rest nearly.
Scan make_corners(Random& random) {
  constexpr double kNoise = 0.01;
  const Vec3 sides(100, 60, 10);
  const double step = 2 + 3 * random.uniform();
  const Eigen::Vector3i cells = (sides / step).array().round().cast<int>();
  Scan scan;
  for (int i = 0; i <= cells.x(); ++i)
    for (int j = 0; j <= cells.y(); ++j)
      for (int k = 0; k <= cells.z(); ++k) {
        const Eigen::Vector3i at(i, j, k);
        const auto ends = ((at.array() == 0) || (at.array() == cells.array())).count();
        if (ends == 0) continue;
        const Vec3 p = sides.cwiseProduct(at.cast<double>().cwiseQuotient(cells.cast<double>()));
        scan.points.push_back(point(ends == 3 ? p : noisy(p, kNoise * step, random)));
        if (ends == 3) scan.needed.push_back(scan.points.back());
      }
  scan.size = sides.maxCoeff();
  scan.volume = sides.prod();
  scan.closed = true;
  scan.least_needed = scan.needed.size();
  return scan;
}

/// A body with a head and ears, and a tail of few points.
Scan make_far_few(Random& random) {
  constexpr std::size_t kPoints = 10000;
  constexpr int kFew = 10;
  constexpr double kSparser = 8, kNoise = 0.1;  // in spacings
  const std::vector<Capsule> parts = {{{0, 0, -0.1}, {0, 0, 0.1}, 0.9},
                                      {{0.7, 0, 0.8}, {0.8, 0, 0.8}, 0.5},
                                      {{0.7, 0.2, 1.1}, {0.5, 0.4, 1.9}, 0.14},
                                      {{0.7, -0.2, 1.1}, {0.5, -0.4, 1.9}, 0.14}};
  const Field field = [&](const Vec3& p) {
    double nearest = INFINITY;
    for (const Capsule& part : parts) nearest = std::min(nearest, part.distance(p));
    return nearest;
  };
  const Mesh surface = make_level_surface(field, {-1.1, -1.1, -1.2}, {1.5, 1.1, 2.2}, 0.03);
  const SurfaceSampler sampler(surface);
  const double spacing = std::sqrt(sampler.area() / kPoints), wide = kSparser * spacing;
  // The tail is a cone along -x of as much area as its points have at this spacing.
  const double radius = 0.7 * wide, length = kFew * wide * wide / (M_PI * radius);
  const double base = -std::sqrt(0.9 * 0.9 - radius * radius), phase = random.uniform();
  Scan scan;
  while (scan.points.size() < kPoints) {
    const Vec3 p = sampler.draw(random).position;
    if (p.x() > 0 || std::hypot(p.y(), p.z()) > radius)
      scan.points.push_back(point(noisy(p, kNoise * spacing, random)));
  }
  for (int i = 0; i < kFew; ++i) {  // from the tip on, of equal areas, in a spiral
    const double share = std::sqrt(i / (kFew - 0.5)), angle = 2 * M_PI * (0.381966 * i + phase);
    scan.needed.push_back(
        {base - (1 - share) * length, share * radius * std::cos(angle), share * radius * std::sin(angle)});
    scan.points.push_back(scan.needed.back());
  }
  scan.size = 1.4 - base + length;
  scan.area = sampler.area() + M_PI * radius * (std::hypot(length, radius) - radius);
  scan.least_needed = kFew - 2;
  return scan;
}

/// The surface that was seen, with its rim. The volume behind it is not asked for.
Scan as_open(Scan scan) {
  scan.volume.reset();
  scan.tolerance = INFINITY;
  return scan;
}

/// A solid with the seen surface on it, the front outside.
Scan as_closed(Scan scan) {
  scan.closed = scan.genus_zero = true;
  scan.one_piece = true;
  scan.least_front = 0;
  scan.most_borders = -1;
  return scan;
}

Scan make_open_room(Random& random) { return as_open(make_room(random, false)); }
Scan make_closed_room(Random& random) { return as_closed(make_room(random, false)); }
Scan make_open_corner(Random& random) { return as_open(make_room(random, true)); }
Scan make_closed_corner(Random& random) { return as_closed(make_room(random, true)); }
Scan make_closed_cliffs(Random& random) { return as_closed(make_cliffs(random)); }
Scan make_closed_sea_bed(Random& random) { return as_closed(make_sea_bed(random)); }

struct Maker {
  ScanKind kind;
  Scan (*make)(Random& random);
  bool turned = true;  // into a random position
};

constexpr const char *kOpen = "ours-open,ours-open-sight", *kClosed = "ours,ours-sight";

constexpr Maker kMakers[] = {
    {{"bottomless_sphere", "a ball without its lowest quarter"}, make_bottomless_sphere},
    {{"bottomless_box", "a box without its bottom"}, make_bottomless_box},
    {{"bottomless_vase", "a vase without top and bottom"}, make_bottomless_vase},
    {{"tube", "a tube that is open at both ends"}, make_tube},
    {{"slices", "a torso on 25 parallel planes"}, make_slices},
    {{"rings", "a room seen by a lidar of 16 beams"}, make_rings},
    {{"figure", "a walking figure seen by three depth cameras"}, make_figure},
    {{"tool", "a thin tool and five stray points"}, make_tool},
    {{"volume", "points that fill a ball"}, make_volume},
    {{"corners", "a plate as a grid with exact corners"}, make_corners},
    {{"far_few", "a dense body with a tail of ten points"}, make_far_few},
    {{"room", "a room with cupboards seen from two to four stations", kOpen}, make_open_room},
    {{"room_solid", "the same as a solid", kClosed}, make_closed_room},
    {{"corner", "a room of the shape of an L, the same way", kOpen}, make_open_corner},
    {{"corner_solid", "the same as a solid", kClosed}, make_closed_corner},
    {{"lidar", "a yard seen by a spinning lidar of 32 beams", kOpen}, make_lidar},
    {{"cliffs", "a raster of heights with cliffs and holes", kOpen}, make_cliffs, false},
    {{"cliffs_solid", "the same as a solid", kClosed}, make_closed_cliffs, false},
    {{"sea_bed", "soundings in degrees and metres", kOpen}, make_sea_bed, false},
    {{"sea_bed_solid", "the same as a solid", kClosed}, make_closed_sea_bed, false}};

void turn(Scan& scan, Random& random) {
  Eigen::Vector4d turn;
  for (double& x : turn) x = random.gauss();
  const Eigen::Matrix3d rotation = Eigen::Quaterniond(turn.normalized()).toRotationMatrix();
  const auto turned = [&](const Point& p) { return point(rotation * Vec3(p[0], p[1], p[2])); };
  for (std::vector<Point>* points : {&scan.points, &scan.needed, &scan.sensors})
    for (Point& p : *points) p = turned(p);
  if (scan.direction) scan.direction = turned(*scan.direction);
}

/// Points and their sensors.
void shuffle(Scan& scan, Random& random) {
  std::vector<std::size_t> order(scan.points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  random.shuffle(order);
  for (std::vector<Point>* values : {&scan.points, &scan.sensors}) {
    if (values->empty()) continue;
    const std::vector<Point> before = *values;
    for (std::size_t i = 0; i < order.size(); ++i) (*values)[i] = before[order[i]];
  }
}

}  // namespace

std::vector<ScanKind> scan_kinds() {
  std::vector<ScanKind> kinds;
  for (const Maker& maker : kMakers) kinds.push_back(maker.kind);
  return kinds;
}

Scan make_scan(const std::string& kind, std::uint64_t seed) {
  const auto maker = std::find_if(std::begin(kMakers), std::end(kMakers),
                                  [&](const Maker& known) { return kind == known.kind.name; });
  if (maker == std::end(kMakers)) throw std::invalid_argument("there is no kind of scan \"" + kind + "\"");
  // With one seed, no two kinds have the same numbers.
  for (const char c : kind) seed = 131 * seed + static_cast<unsigned char>(c);
  Random random(seed);
  Scan scan = maker->make(random);
  if (maker->turned) turn(scan, random);
  shuffle(scan, random);
  return scan;
}

}  // namespace filmsticking::bench
