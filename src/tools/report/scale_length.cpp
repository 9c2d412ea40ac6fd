// SPDX-License-Identifier: GPL-3.0-or-later
#include "scale_length.h"

#include <algorithm>
#include <cmath>

namespace filmsticking::mesh_report {

double scale_length(std::vector<double> distances) {
  distances.erase(
      std::remove_if(distances.begin(), distances.end(), [](double d) { return !(d > 0) || std::isinf(d); }),
      distances.end());
  if (distances.empty()) return 1;
  const std::size_t farthest = distances.size() / 100;
  const auto last = distances.end() - 1 - static_cast<std::ptrdiff_t>(farthest);
  std::nth_element(distances.begin(), last, distances.end());
  const double power = std::pow(10, std::floor(std::log10(*last)));
  for (const double digit : {1, 2, 5})
    if (*last <= digit * power) return digit * power;
  return 10 * power;
}

}  // namespace filmsticking::mesh_report
