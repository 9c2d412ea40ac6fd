// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace filmsticking::bench {

std::optional<double> mean(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::optional<double> standard_deviation(const std::vector<double>& values) {
  const std::optional<double> middle = mean(values);
  if (!middle) return std::nullopt;
  double sum = 0;
  for (const double value : values) sum += (value - *middle) * (value - *middle);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

std::optional<double> geometric_mean(const std::vector<double>& values) {
  std::vector<double> logarithms;
  for (const double value : values) logarithms.push_back(std::log(value));
  const std::optional<double> middle = mean(logarithms);
  return middle ? std::optional(std::exp(*middle)) : std::nullopt;
}

std::optional<double> median(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

std::optional<double> growth_exponent(const std::vector<std::pair<double, double>>& points) {
  std::vector<double> x, y;
  for (const auto& [a, b] : points) {
    x.push_back(std::log(a));
    y.push_back(std::log(b));
  }
  if (points.empty()) return std::nullopt;
  const double middle_x = *mean(x), middle_y = *mean(y);
  double xy = 0, xx = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xy += (x[i] - middle_x) * (y[i] - middle_y);
    xx += (x[i] - middle_x) * (x[i] - middle_x);
  }
  if (!(xx > 0)) return std::nullopt;
  return xy / xx;
}

}  // namespace filmsticking::bench
