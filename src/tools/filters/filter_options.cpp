// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_options.h"

#include <charconv>
#include <cmath>

namespace filmsticking::filters {
namespace {

void check_length(const char* filter, double length) {
  // Below the smallest normal float, PCL's single precision has no inverse of it.
  if (!(length >= 1e-30 && length <= 1e30))
    throw FilterError(std::string(filter) + " takes a length above zero");
}

}  // namespace

std::vector<double> parse_numbers(const std::string& text) {
  std::vector<double> numbers;
  const char* const end = text.data() + text.size();
  for (const char* begin = text.data();; ++begin) {
    double number = 0;
    const auto [rest, error] = std::from_chars(begin, end, number);
    if (error != std::errc() || !std::isfinite(number)) return {};
    numbers.push_back(number);
    if (rest == end) return numbers;
    if (*rest != ',') return {};
    begin = rest;
  }
}

void check(const FilterOptions& options) {
  if (options.crop)
    for (int axis = 0; axis < 3; ++axis)
      if (!(options.crop->least[axis] <= options.crop->most[axis]))
        throw FilterError("crop takes the least x, y, z and then the greatest");
  if (options.outliers) {
    if (options.outliers->neighbours < 1) throw FilterError("sor takes at least one neighbour");
    if (!(options.outliers->deviations >= 0 && options.outliers->deviations <= 1e30))
      throw FilterError("sor takes standard deviations from zero on");
  }
  if (options.voxel) check_length("voxel", *options.voxel);
  if (options.smoothing) check_length("mls", *options.smoothing);
}

const std::vector<FilterChoice>& filter_choices() {
  static const std::vector<FilterChoice> choices = {
      {"crop", "XMIN,YMIN,ZMIN,XMAX,YMAX,ZMAX", "keep the points in this box"},
      {"sor", "K,STDDEV",
       "leave out points whose mean distance to K neighbours is STDDEV standard deviations above the mean"},
      {"voxel", "LEAF", "one point, the mean, for each cell of a grid of this width"},
      {"mls", "RADIUS", "move points to a smooth surface through their neighbours (moving least squares)"},
  };
  return choices;
}

void set_filter(FilterOptions& options, const std::string& name, const std::string& text) {
  const std::vector<double> numbers = parse_numbers(text);
  FilterOptions changed = options;
  for (const FilterChoice& choice : filter_choices()) {
    if (name != choice.name) continue;
    std::string complaint = name;
    complaint.append(" takes ").append(choice.value).append(", not '").append(text).append("'");
    if (name == "crop" && numbers.size() == 6) {
      changed.crop = Box{{numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4], numbers[5]}};
    } else if (name == "sor" && numbers.size() == 2 && numbers[0] == std::floor(numbers[0]) &&
               std::abs(numbers[0]) < 1e9) {
      changed.outliers = OutlierRule{static_cast<int>(numbers[0]), numbers[1]};
    } else if (name == "voxel" && numbers.size() == 1) {
      changed.voxel = numbers[0];
    } else if (name == "mls" && numbers.size() == 1) {
      changed.smoothing = numbers[0];
    } else {
      throw FilterError(complaint);
    }
    try {
      check(changed);
    } catch (const FilterError& error) {
      throw FilterError(std::string(error.what()) + ", not '" + text + "'");
    }
    options = changed;
    return;
  }
  throw FilterError("there is no filter '" + name + "'");
}

}  // namespace filmsticking::filters
