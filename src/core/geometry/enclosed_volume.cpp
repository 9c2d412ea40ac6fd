// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/enclosed_volume.h"

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace filmsticking {
namespace {

/// Six times the volume is a sum of products: calls term(product, sign) for each. Coordinates are relative to
/// a corner of the surface, which keeps their digits, and multiplied by `unit`. They are divided by `part`, a
/// power of two, before the subtraction, so that it cannot overflow.
template <class Number, class Term>
void each_product(const std::vector<Corners>& triangles, const PointsView& places, int part, double unit,
                  const Term& term) {
  const Point o = places[triangles[0][0]];
  const auto relative = [&](Index v) {
    const Point place = places[v];
    std::array<Number, 3> p;
    for (int k = 0; k < 3; ++k) p[k] = (Number(place[k] / part) - Number(o[k] / part)) * Number(unit);
    return p;
  };
  for (const Corners& t : triangles) {
    const auto a = relative(t[0]), b = relative(t[1]), c = relative(t[2]);
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      term(Number(a[k] * b[i] * c[j]), 1);
      term(Number(a[k] * b[j] * c[i]), -1);
    }
  }
}

/// The sign in floating point; 0 where rounding may decide it.
int rounded_sign(const std::vector<Corners>& triangles, const PointsView& places) {
  double longest = 0;
  const Point o = places[triangles[0][0]];
  for (const Corners& t : triangles)
    for (const Index v : t) {
      const Point place = places[v];
      for (int k = 0; k < 3; ++k) longest = std::max(longest, std::abs(place[k] - o[k]));
    }
  constexpr double kFar = 1e290;
  if (!(longest > 1 / kFar && longest < kFar)) return 0;
  // No coordinate is above 2 then, so nothing overflows, and what underflows adds up to less than kTiny.
  const double unit = std::exp2(-std::ilogb(longest));
  constexpr double kTiny = 1e-290;
  double sum = 0, size = 0;
  each_product<double>(triangles, places, 1, unit, [&](double product, int sign) {
    sum += sign * product;
    size += std::abs(product);
  });
  // Five roundings in each product (three differences, two multiplications) and one in each sum.
  const double roundings = 6 * static_cast<double>(triangles.size()) + 16;
  const double error = roundings * std::numeric_limits<double>::epsilon() * size + kTiny;
  return sum > error ? 1 : sum < -error ? -1 : 0;
}

/// Differences of these parts of coordinates do not overflow.
constexpr int kPart = 4;

}  // namespace

int enclosed_volume_sign(const std::vector<Corners>& triangles, const PointsView& places) {
  if (triangles.empty()) return 0;
  if (const int sign = rounded_sign(triangles, places); sign != 0) return sign;
  CGAL::Exact_rational sum = 0;
  each_product<CGAL::Exact_rational>(
      triangles, places, 1, 1, [&](const CGAL::Exact_rational& product, int sign) { sum += sign * product; });
  return CGAL::sign(sum);
}

double enclosing_unit(const PointsView& places) {
  double longest = 0;
  if (places.empty()) return 1;
  const Point o = places[0];
  for (std::size_t v = 0; v < places.size(); ++v) {
    const Point p = places[v];
    for (int k = 0; k < 3; ++k) longest = std::max(longest, std::abs(p[k] / kPart - o[k] / kPart));
  }
  return longest > 0 ? std::exp2(std::clamp(-std::ilogb(longest), -1000, 1000)) : 1;
}

double rounded_volume(const std::vector<Corners>& triangles, const PointsView& places, double unit) {
  double sum = 0;
  each_product<double>(triangles, places, kPart, unit,
                       [&](double product, int sign) { sum += sign * product; });
  return std::abs(sum);
}

}  // namespace filmsticking
