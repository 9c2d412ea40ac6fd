// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

namespace filmsticking::bench {

/// Nothing for no values.
std::optional<double> mean(const std::vector<double>& values);
std::optional<double> standard_deviation(
    const std::vector<double>& values);  ///< of the values, not an estimate
std::optional<double> geometric_mean(const std::vector<double>& values);
std::optional<double> median(std::vector<double> values);

/// The p of y = c x^p, by least squares on the logarithms; nothing for fewer than two different x. All x and
/// y must be positive.
std::optional<double> growth_exponent(const std::vector<std::pair<double, double>>& points);

}  // namespace filmsticking::bench
