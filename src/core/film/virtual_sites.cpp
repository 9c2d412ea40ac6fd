// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/virtual_sites.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "geometry/parallel.h"

namespace filmsticking {
namespace {

struct Ball {
  Vec3 centre;
  double radius;
};

// Starts at the first, largest ball.
std::vector<Vec3> farthest_points(const std::vector<Ball>& balls, std::size_t count) {
  std::vector<Vec3> chosen;
  std::vector<double> distance2(balls.size(), std::numeric_limits<double>::max());
  std::size_t next = 0;
  while (chosen.size() < std::min(count, balls.size())) {  // ends: each turn chooses one
    chosen.push_back(balls[next].centre);
    parallel_each(balls.size(), [&](std::size_t i) {
      distance2[i] = std::min(distance2[i], (balls[i].centre - chosen.back()).squaredNorm());
    });
    next = static_cast<std::size_t>(std::max_element(distance2.begin(), distance2.end()) - distance2.begin());
    if (!(distance2[next] > 0)) break;
  }
  return chosen;
}

// Keeps the chosen balls in a hash grid per power of two of the radius.
std::vector<Vec3> by_local_scale(const std::vector<Ball>& balls, std::size_t most) {
  std::vector<Vec3> chosen;
  std::unordered_map<std::uint64_t, std::vector<Ball>> grid;
  int coarsest = 0, finest = 0;
  bool first = true;
  auto key = [](int level, std::int64_t x, std::int64_t y, std::int64_t z) {
    auto h = static_cast<std::uint64_t>(std::int64_t{level} + 1024);
    for (std::int64_t c : {x, y, z})
      h = (h ^ static_cast<std::uint64_t>(c + (1 << 30))) * 0x9e3779b97f4a7c15ULL, h ^= h >> 31;
    return h;
  };
  auto cell = [](double x, double size) { return static_cast<std::int64_t>(std::floor(x / size)); };
  for (const Ball& ball : balls) {
    if (chosen.size() == most) break;
    const int level = std::ilogb(ball.radius);
    bool free = true;
    for (int l = finest; free && !first && l <= coarsest; ++l) {
      const double size = std::ldexp(1.0, l);  // above the distance that a ball of level l excludes
      const std::int64_t x = cell(ball.centre.x(), size), y = cell(ball.centre.y(), size),
                         z = cell(ball.centre.z(), size);
      for (std::int64_t n = 0; free && n < 27; ++n) {
        const auto found = grid.find(key(l, x + n % 3 - 1, y + n / 3 % 3 - 1, z + n / 9 - 1));
        if (found == grid.end()) continue;
        for (const Ball& other : found->second)
          if ((other.centre - ball.centre).norm() < 0.5 * other.radius) free = false;
      }
    }
    if (!free) continue;
    chosen.push_back(ball.centre);
    const double size = std::ldexp(1.0, level);
    grid[key(level, cell(ball.centre.x(), size), cell(ball.centre.y(), size), cell(ball.centre.z(), size))]
        .push_back(ball);
    coarsest = first ? level : std::max(coarsest, level);
    finest = first ? level : std::min(finest, level);
    first = false;
  }
  return chosen;
}

}  // namespace

std::vector<Vec3> virtual_sites(const TetrahedralMesh& mesh, const std::vector<double>& spacing, int count,
                                const std::vector<char>& wanted) {
  std::vector<Ball> balls;
  for (std::size_t t = 0; t < mesh.size(); ++t) {
    if (mesh.tets.infinite(static_cast<Index>(t)) || !wanted[t]) continue;
    double local = 0;
    for (Index i : mesh.tets.corners[t]) local = std::max(local, spacing[i]);
    if (mesh.circumradius[t] > 2 * local) balls.push_back({mesh.circumcentre[t], mesh.circumradius[t]});
  }
  std::sort(balls.begin(), balls.end(), [](const Ball& a, const Ball& b) {
    if (a.radius != b.radius) return a.radius > b.radius;
    return std::lexicographical_compare(a.centre.data(), a.centre.data() + 3, b.centre.data(),
                                        b.centre.data() + 3);
  });
  if (count <= 0) return by_local_scale(balls, spacing.size());
  // Farthest-point sampling needs no more candidates than this to be even.
  constexpr std::size_t kMost = 100000;
  if (balls.size() > kMost) {
    std::vector<Ball> fewer;
    for (std::size_t i = 0; i < kMost; ++i) fewer.push_back(balls[i * balls.size() / kMost]);
    balls.swap(fewer);
  }
  return farthest_points(balls, static_cast<std::size_t>(count));
}

}  // namespace filmsticking
