// SPDX-License-Identifier: GPL-3.0-or-later
#include "no_return.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cloud.h"

namespace filmsticking::io {
namespace {

// As the core's sites have it: src/core/points/site_set.cpp.
constexpr double kAbsurd = 1e4, kCore = 2.0 / 3;

constexpr double kMissing[] = {-9999, -99999, -999999, -32768, -32767, -9999.9, -999, -9999999};

bool is_missing(double z) {
  constexpr double kHighest = -999;
  return z <= kHighest && std::find(std::begin(kMissing), std::end(kMissing), z) != std::end(kMissing);
}

double ranked(std::vector<double>& values, double share) {
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

std::vector<bool> absurdly_far(const std::vector<Point>& points) {
  std::vector<bool> far(points.size());
  std::vector<double> values;
  Point median{};
  for (std::size_t k = 0; k < 3; ++k) {
    values.clear();
    for (const Point& p : points)
      if (is_finite(p)) values.push_back(p[k]);
    if (values.empty()) return std::vector<bool>(points.size(), true);
    median[k] = ranked(values, 0.5);
  }
  // Halves, along the axes: differences and squares would overflow.
  const auto distance = [&](const Point& p) {
    return std::max({std::abs(p[0] / 2 - median[0] / 2), std::abs(p[1] / 2 - median[1] / 2),
                     std::abs(p[2] / 2 - median[2] / 2)});
  };
  values.clear();
  for (const Point& p : points)
    if (is_finite(p)) values.push_back(distance(p));
  const double most = kAbsurd * ranked(values, kCore);
  for (std::size_t i = 0; i < points.size(); ++i)
    far[i] = !is_finite(points[i]) || (most > 0 && distance(points[i]) > most);
  return far;
}

std::size_t mark_missing_heights(pcl::PCLPointCloud2& cloud) {
  if (size_of(cloud) == 0) return 0;
  const PositionFields fields(cloud);
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  double least = kInfinite, most = -kInfinite,
         highest_missing = *std::min_element(kMissing, std::end(kMissing));
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < size_of(cloud); ++i) {
    const double z = fields.load(bytes_of(cloud, i))[2];
    if (is_missing(z)) {
      missing.push_back(i);
      highest_missing = std::max(highest_missing, z);
    } else if (std::isfinite(z)) {
      least = std::min(least, z), most = std::max(most, z);
    }
  }
  if (missing.empty() || !(least - highest_missing > most - least)) return 0;
  constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
  for (const std::size_t i : missing)
    fields.store({kNotANumber, kNotANumber, kNotANumber},
                 cloud.data.data() + (bytes_of(cloud, i) - cloud.data.data()));
  return missing.size();
}

}  // namespace filmsticking::io
