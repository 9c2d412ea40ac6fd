// SPDX-License-Identifier: GPL-3.0-or-later
#include "row.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace filmsticking::bench {

const std::vector<std::string>& judged_columns() {
  static const std::vector<std::string> names = {"vertices",
                                                 "faces",
                                                 "interpolated",
                                                 "cloud_distance_mean",
                                                 "closed",
                                                 "manifold",
                                                 "oriented",
                                                 "outward",
                                                 "boundary_edges",
                                                 "non_manifold_edges",
                                                 "non_manifold_vertices",
                                                 "self_intersections",
                                                 "components",
                                                 "genus",
                                                 "components_right",
                                                 "genus_right",
                                                 "topology_right",
                                                 "chamfer_e3",
                                                 "f_score",
                                                 "normal_consistency",
                                                 "turned_over",
                                                 "hausdorff",
                                                 "sharp_edges_restored"};
  return names;
}

const std::vector<std::string>& columns() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all = {
        "shape",       "kind",      "points",          "seed",   "method",  "threads",
        "run",         "status",    "message",         "timing", "seconds", "seconds_with_needs",
        "cpu_seconds", "memory_mb", "bytes_per_point", "rooms",  "steps",   "fields"};
    all.insert(all.end(), judged_columns().begin(), judged_columns().end());
    return all;
  }();
  return names;
}

std::string to_text(double value) {
  char digits[64];
  return std::string(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

void Row::set(const std::string& column, const std::string& text) {
  if (std::find(columns().begin(), columns().end(), column) == columns().end())
    throw std::logic_error("there is no column " + column);
  texts_[column] = text;
}

void Row::set(const std::string& column, double value) { set(column, to_text(value)); }

const std::string& Row::text(const std::string& column) const {
  static const std::string empty;
  const auto found = texts_.find(column);
  return found == texts_.end() ? empty : found->second;
}

std::optional<double> Row::number(const std::string& column) const {
  const std::string& digits = text(column);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (digits.empty() || error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

std::string Row::key() const {
  std::string key;
  for (std::size_t i = 0; i < kKeyColumns; ++i) key += text(columns()[i]) + '\n';
  return key;
}

}  // namespace filmsticking::bench
