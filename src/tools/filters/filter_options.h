// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "filmsticking/types.h"
#include "filter_error.h"

namespace filmsticking::filters {

/// A box along the axes; its border belongs to it.
struct Box {
  Point least{};
  Point most{};
};

/// A point is an outlier if its mean distance to its `neighbours` nearest points is more than `deviations`
/// standard deviations above the mean of all points (PCL's StatisticalOutlierRemoval).
struct OutlierRule {
  int neighbours = 16;
  double deviations = 3;
};

/// The filters in the order in which they run; one without a value does not run. Lengths are in the cloud's
/// unit.
struct FilterOptions {
  std::optional<Box> crop;              ///< keep the points in a box
  std::optional<OutlierRule> outliers;  ///< leave outliers out
  std::optional<double> voxel;          ///< one point, the mean, for each cell of a grid of this width
  std::optional<double> smoothing;      ///< radius of moving least squares

  bool any() const { return crop || outliers || voxel || smoothing; }
};

/// Throws FilterError for a value that is out of its range.
void check(const FilterOptions& options);

/// The numbers of "1,2.5,-3"; empty if it is anything else.
std::vector<double> parse_numbers(const std::string& text);

/// One filter as a program's option.
struct FilterChoice {
  const char* name;   ///< "voxel": without dashes
  const char* value;  ///< the form of its text: "LEAF"
  const char* help;
};

/// All filters in the order in which they run: crop, sor, voxel, mls.
const std::vector<FilterChoice>& filter_choices();

/// Sets the filter of that name by `text`. Throws FilterError for an unknown name or a bad text.
void set_filter(FilterOptions& options, const std::string& name, const std::string& text);

}  // namespace filmsticking::filters
