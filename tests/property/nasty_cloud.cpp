// SPDX-License-Identifier: GPL-3.0-or-later
#include "nasty_cloud.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/clouds.h"

namespace filmsticking::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double power_of_ten(Random& random, double low, double high) {
  return std::pow(10, random.uniform(low, high));
}

Point in_cube(Random& random) {
  return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

/// One of many shapes, within 1 or so of the origin.
std::vector<Point> shape(Random& random, int n) {
  const int kind = random.below(14), cells = 1 + random.below(12);
  const double thickness = power_of_ten(random, -17, 0);
  const Point a = in_cube(random), b = in_cube(random);
  std::vector<Point> points;
  for (int i = 0; i < n; ++i) {
    Point p = in_cube(random);
    const double turn = random.uniform(0, 2 * M_PI);
    switch (kind) {
      case 0:  // noise
        break;
      case 1:  // cospherical
        p = random.direction();
        break;
      case 2:  // a grid, with repeated points
        for (double& x : p) x = std::round(cells * x) / cells;
        break;
      case 3:  // a grid from its corner
        p = {double(i % cells), double(i / cells % cells), double(i / cells / cells)};
        break;
      case 4:  // nearly a plane
        p[2] *= thickness;
        break;
      case 5:  // nearly a line
        p[1] *= thickness, p[2] *= thickness;
        break;
      case 6:  // two skew lines
        p = random.below(2) ? Point{p[0], -0.5, 0} : Point{0, 0.5, p[0]};
        break;
      case 7:  // two circles: the Delaunay triangulation is quadratic
        p = random.below(2) ? Point{std::cos(turn), std::sin(turn), 0}
                            : Point{1 + std::cos(turn), 0, std::sin(turn)};
        break;
      case 8:  // two layers, perhaps nearer than numbers are
        p[2] = random.below(2) * thickness;
        break;
      case 9:  // a cluster in a cloud
        if (random.below(3))
          for (int k = 0; k < 3; ++k) p[k] = a[k] + thickness * p[k];
        break;
      case 10:  // two clusters
        for (int k = 0; k < 3; ++k) p[k] = (i % 2 ? a[k] : b[k]) + thickness * p[k];
        break;
      case 11:  // a box's surface
        p[random.below(3)] = random.below(2) ? 1 : -1;
        break;
      case 12:  // a moment curve: every two points are Delaunay neighbours
        p = {p[0], p[0] * p[0], p[0] * p[0] * p[0]};
        break;
      default:  // spheres in each other
        p = random.direction();
        for (double& x : p) x *= 1 + i % 3;
        break;
    }
    points.push_back(p);
  }
  return points;
}

/// Repeats of earlier points, some with one coordinate changed.
void repeat(Random& random, std::vector<Point>& points, bool exactly) {
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    Point p = points[static_cast<std::size_t>(random.below(static_cast<int>(n)))];
    if (!exactly)
      for (double& x : p)
        if (random.below(2)) x = std::nextafter(x, random.below(2) ? kInfinity : -kInfinity);
    points.push_back(p);
  }
}

/// By a random angle around each axis.
void turn(Random& random, std::vector<Point>& points) {
  for (int axis = 0; axis < 3; ++axis) {
    const double angle = random.uniform(0, 2 * M_PI), c = std::cos(angle), s = std::sin(angle);
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    for (Point& p : points) {
      const double x = p[i], y = p[j];
      p[i] = c * x - s * y;
      p[j] = s * x + c * y;
    }
  }
}

void scale(std::vector<Point>& points, double x, double y, double z) {
  for (Point& p : points) p = {p[0] * x, p[1] * y, p[2] * z};
}

void move(std::vector<Point>& points, const Point& by) {
  for (Point& p : points)
    for (int k = 0; k < 3; ++k) p[k] += by[k];
}

int some_size(Random& random) {
  const int kind = random.below(100);
  if (kind < 35) return random.below(13);
  if (kind < 80) return random.below(120);
  if (kind < 97) return random.below(500);
  return random.below(2001);
}

void shuffle(Random& random, std::vector<Point>& points) {
  for (std::size_t i = points.size(); i > 1; --i)
    std::swap(points[i - 1], points[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
}

std::vector<Point> shapes(Random& random, int n) {
  const int parts = 1 + (random.below(3) == 0 ? random.below(4) : 0);
  const bool mixed = random.below(6) == 0, turned = random.below(2) == 0;
  std::vector<Point> points;
  for (int part = 0; part < parts; ++part) {
    std::vector<Point> some = shape(random, n / parts);
    if (turned) turn(random, some);
    if (mixed) {
      const double size = power_of_ten(random, -30, 30);
      scale(some, size, size, size);
    } else if (parts > 1) {
      move(some, {random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)});
    }
    points.insert(points.end(), some.begin(), some.end());
  }
  return points;
}

}  // namespace

std::vector<Point> nasty_cloud(std::uint64_t seed) {
  Random random(seed);
  const int n = some_size(random), repeats = random.below(8);
  std::vector<Point> points = shapes(random, repeats < 2 ? n / 2 : n);

  if (random.below(8) == 0)
    scale(points, power_of_ten(random, -9, 0), power_of_ten(random, -9, 0), power_of_ten(random, -9, 0));
  switch (random.below(10)) {
    case 0: {
      const double size = power_of_ten(random, -30, 30);
      scale(points, size, size, size);
      break;
    }
    case 1:  // a map's coordinates, in millimetres
      move(points, {500000, 4649776, 123});
      for (Point& p : points)
        for (double& x : p) x = std::round(x * 1000) / 1000;
      break;
    case 2: {
      const double far = power_of_ten(random, 3, 16);
      move(points, {far, -far, far * random.uniform()});
      break;
    }
    case 3:  // denormal, or nearly
      scale(points, 1e-300, 1e-300, 1e-300);
      scale(points, power_of_ten(random, -24, 0), power_of_ten(random, -24, 0), power_of_ten(random, -24, 0));
      break;
    case 4: {  // up to the largest numbers
      scale(points, 1e200, 1e200, 1e200);
      const double size = power_of_ten(random, 60, 108);
      scale(points, size, size, size);
      break;
    }
    default:
      break;
  }
  if (random.below(3) == 0)
    for (Point& p : points)
      for (double& x : p) x = static_cast<float>(x);
  if (repeats < 2) repeat(random, points, repeats == 0);
  if (random.below(8) == 0)
    for (Point& p : points)
      if (random.below(5) == 0) {
        const double strange[] = {std::nan(""), kInfinity, -kInfinity, -0.0, 5e-324};
        p[random.below(3)] = strange[random.below(5)];
      }
  shuffle(random, points);
  return points;
}

std::vector<Point> dyadic_cloud(std::uint64_t seed) {
  Random random(seed);
  std::vector<Point> points = shapes(random, random.below(300));
  double most = 1e-300;
  for (const Point& p : points)
    for (const double x : p) most = std::max(most, std::abs(x));
  for (Point& p : points)
    for (double& x : p) x = std::round(x / most * 1048576) / 1048576;
  return points;
}

}  // namespace filmsticking::test
