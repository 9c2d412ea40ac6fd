// SPDX-License-Identifier: GPL-3.0-or-later
#include "invariance.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <set>

#include "filmsticking/reconstruct.h"
#include "support/clouds.h"

namespace filmsticking::test {
namespace {

/// A result in a form that does not depend on the order of the points: status, and faces with the places of
/// their corners, each turned to its least corner.
struct Shape {
  Status status = Status::Ok;
  std::vector<std::array<Point, 3>> faces;
  bool operator==(const Shape& other) const { return status == other.status && faces == other.faces; }
};

/// `place`: [point of the input]: its coordinates in the comparison.
Shape shape_of(const Result& result, const std::vector<Point>& place) {
  Shape shape;
  shape.status = result.status;
  for (const Triangle& t : result.triangles) {
    std::array<Point, 3> face;
    for (int k = 0; k < 3; ++k) {
      face[k] = place[result.vertices[t[k]]];
      for (double& x : face[k]) x += 0.0;  // -0 becomes 0
    }
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    shape.faces.push_back(face);
  }
  std::sort(shape.faces.begin(), shape.faces.end());
  return shape;
}

Result run(const std::vector<Point>& points, int threads = 1) {
  Options options;
  options.threads = threads;
  return reconstruct(points, options);
}

std::vector<Point> mapped(std::vector<Point> points, const std::function<Point(const Point&)>& map) {
  for (Point& p : points) p = map(p);
  return points;
}

/// The 24 turns of a cube, as axes and signs.
struct Turn {
  std::array<int, 3> axis;
  std::array<int, 3> sign;
  Point operator()(const Point& p) const {
    return {sign[0] * p[axis[0]], sign[1] * p[axis[1]], sign[2] * p[axis[2]]};
  }
};

std::vector<Turn> turns() {
  std::vector<Turn> all;
  std::array<int, 3> axis{0, 1, 2};
  do {
    const bool odd = (axis[0] > axis[1]) ^ (axis[1] > axis[2]) ^ (axis[0] > axis[2]);
    for (int signs = 0; signs < 8; ++signs) {
      const std::array<int, 3> sign{signs & 1 ? -1 : 1, signs & 2 ? -1 : 1, signs & 4 ? -1 : 1};
      if (sign[0] * sign[1] * sign[2] == (odd ? -1 : 1)) all.push_back({axis, sign});
    }
  } while (std::next_permutation(axis.begin(), axis.end()));
  return all;
}

/// Around the middle of their box.
bool maps_onto_itself(const std::vector<Point>& points, const Turn& turn) {
  Point low = points[0], high = points[0];
  for (const Point& p : points)
    for (int k = 0; k < 3; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
  std::set<Point> before, after;
  for (Point p : points) {
    for (int k = 0; k < 3; ++k) p[k] = 2 * p[k] - (low[k] + high[k]);  // exact for a dyadic cloud
    Point q = turn(p);
    for (double& x : q) x += 0.0;
    before.insert(p);
    after.insert(q);
  }
  return before == after;
}

}  // namespace

std::string invariance_fault(const std::vector<Point>& points, std::uint64_t seed) {
  const Result first = run(points);
  for (const int threads : {1, 2, 8}) {
    const Result other = run(points, threads);
    if (other.status != first.status || other.vertices != first.vertices ||
        other.triangles != first.triangles)
      return threads == 1 ? "a second run gives another mesh"
                          : std::to_string(threads) + " threads give another mesh";
  }
  const Shape shape = shape_of(first, points);

  Random random(seed);
  std::vector<Point> shuffled = points;
  for (std::size_t i = shuffled.size(); i > 1; --i)
    std::swap(shuffled[i - 1], shuffled[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
  if (!(shape_of(run(shuffled), shuffled) == shape)) return "another order gives another mesh";

  for (const int power : {-7, 1, 40}) {
    const std::vector<Point> scaled = mapped(points, [&](Point p) {
      for (double& x : p) x = std::ldexp(x, power);
      return p;
    });
    if (!(shape_of(run(scaled), points) == shape))
      return "scaling by 2^" + std::to_string(power) + " gives another mesh";
  }
  return "";
}

std::string move_fault(const std::vector<Point>& points) {
  const Shape shape = shape_of(run(points), points);
  for (const Point& by : {Point{4, -8, 1024}, Point{-1048576, 2, 0.5}, Point{0, 0, 33554432}}) {
    const std::vector<Point> moved = mapped(points, [&](const Point& p) {
      return Point{p[0] + by[0], p[1] + by[1], p[2] + by[2]};
    });
    if (!(shape_of(run(moved), points) == shape)) return "a move gives another mesh";
  }
  return "";
}

std::string turn_fault(const std::vector<Point>& points) {
  if (points.empty()) return "";
  for (const Turn& turn : turns()) {
    const bool identity =
        turn.axis == std::array<int, 3>{0, 1, 2} && turn.sign == std::array<int, 3>{1, 1, 1};
    if (!identity && maps_onto_itself(points, turn)) return "";
  }
  const Shape shape = shape_of(run(points), points);
  // Those around each axis make all of the others.
  for (const Turn& turn :
       {Turn{{0, 2, 1}, {1, -1, 1}}, Turn{{2, 1, 0}, {1, 1, -1}}, Turn{{1, 0, 2}, {-1, 1, 1}}})
    if (!(shape_of(run(mapped(points, turn)), points) == shape))
      return "a turn by 90 degrees gives another mesh";
  return "";
}

}  // namespace filmsticking::test
