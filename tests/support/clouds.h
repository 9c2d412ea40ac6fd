// SPDX-License-Identifier: GPL-3.0-or-later
// Clouds for the core's tests: generated ones from a seed, and the bundled real ones.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "filmsticking/types.h"

namespace filmsticking::test {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double uniform(double lo = 0, double hi = 1) {
    return lo + (hi - lo) * static_cast<double>(engine_() >> 11) / 9007199254740992.0;
  }
  int below(int n) { return static_cast<int>(uniform() * n) % n; }
  Point direction() {
    for (;;) {
      const Point p{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
      const double l2 = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
      if (l2 > 1e-4 && l2 < 1) return {p[0] / std::sqrt(l2), p[1] / std::sqrt(l2), p[2] / std::sqrt(l2)};
    }
  }

 private:
  std::mt19937_64 engine_;
};

inline std::vector<Point> sphere(int n, std::uint64_t seed, Point centre = {0, 0, 0}, double radius = 1) {
  Random random(seed);
  std::vector<Point> points;
  for (int i = 0; i < n; ++i) {
    const Point d = random.direction();
    points.push_back({centre[0] + radius * d[0], centre[1] + radius * d[1], centre[2] + radius * d[2]});
  }
  return points;
}

// An ellipsoid: no five of its points are on a sphere, so its tetrahedra are well away from flat.
inline std::vector<Point> ellipsoid(int n, std::uint64_t seed, double x0) {
  std::vector<Point> points = sphere(n, seed);
  for (Point& p : points) p = {x0 + p[0], 0.8 * p[1], 0.6 * p[2]};
  return points;
}

/// Area-uniform on a torus around z.
inline std::vector<Point> torus(int n, std::uint64_t seed, double big = 1, double small = 0.4) {
  Random random(seed);
  std::vector<Point> points;
  while (static_cast<int>(points.size()) < n) {
    const double u = random.uniform(0, 2 * M_PI), v = random.uniform(0, 2 * M_PI);
    const double r = big + small * std::cos(v);
    if (random.uniform() * (big + small) > r) continue;
    points.push_back({r * std::cos(u), r * std::sin(u), small * std::sin(v)});
  }
  return points;
}

/// What a depth camera at `eye`, which looks along -z, sees of spheres (x, y, z and radius of each): the
/// first hits of its rays through pixels of this size at distance 1.
inline std::vector<Point> depth_view(const std::vector<std::array<double, 4>>& spheres, const Point& eye,
                                     double pixel) {
  std::vector<Point> points;
  const int half = static_cast<int>(1 / pixel);
  for (int v = -half; v <= half; ++v)
    for (int u = -half; u <= half; ++u) {
      const Point ray{u * pixel, v * pixel, -1};
      const double a = ray[0] * ray[0] + ray[1] * ray[1] + 1;
      double first = INFINITY;
      for (const auto& s : spheres) {
        double b = 0, c = -s[3] * s[3];
        for (int k = 0; k < 3; ++k) b += ray[k] * (eye[k] - s[k]), c += (eye[k] - s[k]) * (eye[k] - s[k]);
        if (b * b > a * c) first = std::min(first, (-b - std::sqrt(b * b - a * c)) / a);
      }
      if (first < INFINITY)
        points.push_back({eye[0] + first * ray[0], eye[1] + first * ray[1], eye[2] - first});
    }
  return points;
}

/// Area-uniform on what a polyline of (distance from the axis, z) sweeps around the axis z.
inline std::vector<Point> revolved(int n, std::uint64_t seed,
                                   const std::vector<std::array<double, 2>>& profile) {
  Random random(seed);
  std::vector<double> until{0};  // the area up to each corner, over pi
  for (std::size_t i = 1; i < profile.size(); ++i)
    until.push_back(until.back() +
                    (profile[i][0] + profile[i - 1][0]) *
                        std::hypot(profile[i][0] - profile[i - 1][0], profile[i][1] - profile[i - 1][1]));
  std::vector<Point> points;
  while (static_cast<int>(points.size()) < n) {
    const double x = random.uniform(0, until.back());
    std::size_t i = 1;
    while (i + 1 < until.size() && until[i] <= x) ++i;
    const double t = random.uniform(), r = profile[i - 1][0] + t * (profile[i][0] - profile[i - 1][0]);
    if (random.uniform() * std::max(profile[i][0], profile[i - 1][0]) > r) continue;
    const double turn = random.uniform(0, 2 * M_PI);
    points.push_back({r * std::cos(turn), r * std::sin(turn),
                      profile[i - 1][1] + t * (profile[i][1] - profile[i - 1][1])});
  }
  return points;
}

/// Uniform on the faces of a box of the given sizes.
inline std::vector<Point> box(int n, std::uint64_t seed, Point size) {
  Random random(seed);
  const double area[3] = {size[1] * size[2], size[2] * size[0], size[0] * size[1]};
  std::vector<Point> points;
  for (int i = 0; i < n; ++i) {
    double x = random.uniform() * (area[0] + area[1] + area[2]);
    int axis = 0;
    while (axis < 2 && x > area[axis]) x -= area[axis++];
    Point p{random.uniform() * size[0], random.uniform() * size[1], random.uniform() * size[2]};
    p[axis] = random.below(2) * size[axis];
    points.push_back(p);
  }
  return points;
}

/// Uniform on a plate of width 1 with four by four hills on its upper side, a tenth high; `thickness` between
/// the hills.
inline std::vector<Point> relief(int n, std::uint64_t seed, double thickness) {
  Random random(seed);
  const auto height = [&](double u, double v) {
    return thickness + 0.1 * (1 - std::cos(8 * M_PI * u)) * (1 - std::cos(8 * M_PI * v)) / 4;
  };
  const double steepest = 2.2, sides = 4 * thickness;  // steepest: more than area over its shadow
  std::vector<Point> points;
  while (static_cast<int>(points.size()) < n) {
    const double u = random.uniform(), v = random.uniform();
    const double where = random.uniform() * (1 + steepest + sides), h = 1e-4;
    if (where < 1) {
      points.push_back({u, v, 0});
    } else if (where < 1 + steepest) {
      const double z = height(u, v), du = (height(u + h, v) - z) / h, dv = (height(u, v + h) - z) / h;
      if (where - 1 < std::sqrt(1 + du * du + dv * dv)) points.push_back({u, v, z});
    } else {
      const double end = random.below(2);
      if (random.below(2))
        points.push_back({u, end, v * thickness});
      else
        points.push_back({end, u, v * thickness});
    }
  }
  return points;
}

inline std::vector<Point> grid(int n) {
  std::vector<Point> points;
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y)
      for (int z = 0; z < n; ++z) points.push_back({double(x), double(y), double(z)});
  return points;
}

/// A small cloud of one of many awkward kinds.
inline std::vector<Point> awkward(std::uint64_t seed) {
  Random random(seed);
  const int n = random.below(120);
  const int kind = random.below(8);
  const double scale = std::pow(10, random.uniform(-6, 6));
  const Point offset{random.uniform(-1, 1) * 1e3 * scale, 0, random.uniform(-1, 1) * scale};
  std::vector<Point> points;
  for (int i = 0; i < n; ++i) {
    Point p{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    switch (kind) {
      case 0:
        break;  // a ball of noise
      case 1:
        p = random.direction();
        break;  // cospherical
      case 2:
        for (double& x : p) x = std::round(3 * x);
        break;  // a grid, with duplicates
      case 3:
        p[2] = 0;
        break;  // a plane
      case 4:
        p[1] = p[2] = 0;
        break;  // a line
      case 5:
        p[2] = random.below(2) * 1e-6;
        break;  // two planes closer than anything
      case 6:
        if (random.below(2))
          for (double& x : p) x = 0.5 + 1e-9 * x;
        break;  // a cluster within a cloud
      default:
        if (i % 7 == 0) p[random.below(3)] = random.below(2) ? NAN : INFINITY;
        break;
    }
    for (int k = 0; k < 3; ++k) p[k] = p[k] * scale + offset[k];
    points.push_back(p);
  }
  return points;
}

/// The bundled clouds: text PCD, and binary PLY of floats x y z.
inline std::vector<Point> read_text_pcd(const std::string& path) {
  std::ifstream in(path);
  std::vector<Point> points;
  bool data = false;
  for (std::string line; std::getline(in, line);) {
    if (!data) {
      data = line.rfind("DATA", 0) == 0;
      continue;
    }
    std::istringstream fields(line);
    Point p;
    if (fields >> p[0] >> p[1] >> p[2]) points.push_back({float(p[0]), float(p[1]), float(p[2])});
  }
  return points;
}

inline std::vector<Point> read_float_ply(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::size_t count = 0;
  for (std::string line; std::getline(in, line) && line != "end_header";)
    if (line.rfind("element vertex ", 0) == 0) count = std::stoul(line.substr(15));
  std::vector<Point> points(count);
  for (Point& p : points) {
    float xyz[3];
    in.read(reinterpret_cast<char*>(xyz), sizeof xyz);
    p = {xyz[0], xyz[1], xyz[2]};
  }
  return points;
}

}  // namespace filmsticking::test
