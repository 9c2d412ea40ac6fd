// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes whose figures follow from formulas.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "support/model.h"

namespace filmsticking::test {

inline Model box(const Point& lo = {0, 0, 0}, const Point& hi = {1, 1, 1}) {
  Model model;
  for (int i = 0; i < 8; ++i)
    model.positions.push_back({i & 1 ? hi[0] : lo[0], i & 2 ? hi[1] : lo[1], i & 4 ? hi[2] : lo[2]});
  model.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                     {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {2, 6, 7}, {2, 7, 3}};
  return model;
}

/// The parallelogram from `origin` along `u` and `v`, n x n x 2 triangles.
inline Model plane(const Point& origin, const Point& u, const Point& v, int n) {
  Model model;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      Point p;
      for (int k = 0; k < 3; ++k) p[k] = origin[k] + u[k] * i / n + v[k] * j / n;
      model.positions.push_back(p);
    }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const int a = i * (n + 1) + j, b = a + n + 1;
      model.triangles.push_back({a, b, b + 1});
      model.triangles.push_back({a, b + 1, a + 1});
    }
  return model;
}

/// A grid of n x n vertices closed in both directions. `twist`: the second direction comes back reversed.
inline Model wrapped_grid(int n, bool twist, const std::function<Point(double, double)>& at) {
  Model model;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) model.positions.push_back(at(2 * M_PI * i / n, 2 * M_PI * j / n));
  const auto id = [&](int i, int j) {
    if (i == n && twist) j = n - j;
    return i % n * n + j % n;
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      model.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      model.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  return model;
}

inline Model torus(const Point& centre = {0, 0, 0}, int n = 40) {
  return wrapped_grid(n, false, [&](double u, double v) {
    const double r = 1 + 0.4 * std::cos(v);
    return Point{centre[0] + r * std::cos(u), centre[1] + r * std::sin(u), centre[2] + 0.4 * std::sin(v)};
  });
}

/// One-sided; the places of the vertices matter little.
inline Model klein_bottle() {
  return wrapped_grid(12, true, [](double u, double v) {
    return Point{std::cos(u) * (3 + std::cos(u / 2) * std::sin(v) - std::sin(u / 2) * std::sin(2 * v)),
                 std::sin(u) * (3 + std::cos(u / 2) * std::sin(v) - std::sin(u / 2) * std::sin(2 * v)),
                 std::sin(u / 2) * std::sin(v) + std::cos(u / 2) * std::sin(2 * v)};
  });
}

/// An inscribed polyhedron of parallels and meridians. The gap between two of them is that of the spheres but
/// for 0.05 %.
inline Model sphere(double radius) {
  constexpr int kRows = 100, kColumns = 200;
  Model model;
  for (int i = 1; i < kRows; ++i)
    for (int j = 0; j < kColumns; ++j) {
      const double theta = M_PI * i / kRows, phi = 2 * M_PI * j / kColumns;
      model.positions.push_back({radius * std::sin(theta) * std::cos(phi),
                                 radius * std::sin(theta) * std::sin(phi), radius * std::cos(theta)});
    }
  const int north = static_cast<int>(model.positions.size()), south = north + 1;
  model.positions.push_back({0, 0, radius});
  model.positions.push_back({0, 0, -radius});
  const auto id = [&](int i, int j) { return (i - 1) * kColumns + j % kColumns; };
  for (int j = 0; j < kColumns; ++j) {
    model.triangles.push_back({north, id(1, j), id(1, j + 1)});
    model.triangles.push_back({south, id(kRows - 1, j + 1), id(kRows - 1, j)});
    for (int i = 1; i + 1 < kRows; ++i) {
      model.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      model.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  }
  return model;
}

inline Model triangles(const std::vector<Point>& positions, const std::vector<Triangle>& faces) {
  return {positions, {}, faces};
}

inline Model joined(Model a, const Model& b) {
  const auto shift = static_cast<std::int32_t>(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (const Triangle& t : b.triangles) a.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  return a;
}

inline Model turned(Model model) {
  for (Triangle& t : model.triangles) std::swap(t[1], t[2]);
  return model;
}

}  // namespace filmsticking::test
