// SPDX-License-Identifier: GPL-3.0-or-later
// Clouds that are dense beside the features of closed surfaces.
#pragma once

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "clouds.h"

namespace filmsticking::test {

// On the golden spiral of an ellipsoid, each shaken by up to a fifth of the spacing.
inline std::vector<Point> even_ellipsoid(int n, std::uint64_t seed) {
  Random random(seed);
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

inline std::map<std::string, std::vector<Point>> clean_clouds() {
  std::map<std::string, std::vector<Point>> clouds;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const std::string name = " " + std::to_string(seed);
    clouds["sphere" + name] = sphere(2000, seed);
    clouds["torus" + name] = torus(3000, seed);
    clouds["even ellipsoid" + name] = even_ellipsoid(2000, seed);
    clouds["block" + name] = box(3000, seed, {1, 1, 1});
    auto two = even_ellipsoid(1500, seed);
    for (Point p : torus(2000, seed)) p[0] += 4, two.push_back(p);
    clouds["two" + name] = two;
  }
  clouds["spot"] = read_float_ply(TEST_DATA "/spot_10k.ply");
  return clouds;
}

}  // namespace filmsticking::test
