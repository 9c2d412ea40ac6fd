// SPDX-License-Identifier: GPL-3.0-or-later
#include "text_columns.h"

#include <algorithm>
#include <cmath>

#include "cloud.h"
#include "io_error.h"

namespace filmsticking::io {
namespace {

int significant_digits(std::string_view word) {
  int digits = 0;
  for (const char c : word) {
    if (c == 'e' || c == 'E' || c == 'd' || c == 'D') break;
    if (c >= '0' && c <= '9' && (digits > 0 || c != '0')) ++digits;
  }
  return digits;
}

/// Three columns side by side.
class Triples {
 public:
  explicit Triples(const TableFacts& facts) : facts_(facts) {}

  bool normals(std::size_t k) const {
    return numbers(k) && 100 * facts_.unit[k] >= 99 * facts_.rows && facts_.rows > 0;
  }

  /// From 0 to 255 in whole numbers, but not 0 and 1 alone; or from 0 to 1 with fractions.
  bool colours(std::size_t k) const {
    if (!numbers(k)) return false;
    double least = 0, most = 0;
    bool whole = true;
    for (std::size_t i = k; i < k + 3; ++i) {
      least = std::min(least, facts_.columns[i].least);
      most = std::max(most, facts_.columns[i].most);
      whole &= facts_.columns[i].whole;
    }
    return least >= 0 && (whole ? most >= 2 && most <= 255 : most <= 1 && !normals(k));
  }

 private:
  bool numbers(std::size_t k) const {
    if (k + 3 > facts_.columns.size()) return false;
    return std::none_of(facts_.columns.begin() + static_cast<std::ptrdiff_t>(k),
                        facts_.columns.begin() + static_cast<std::ptrdiff_t>(k) + 3,
                        [](const ColumnFacts& c) { return c.text || c.most < c.least; });
  }

  const TableFacts& facts_;
};

/// Whether the column numbers the points, or is their time. Of a surface, x does not rise evenly from point
/// to point.
bool is_ahead(const TableFacts& facts, std::size_t k) {
  constexpr double kTimes = 1e8;  // no coordinate in metres is as large; seconds since 1970 and GPS times are
  if (facts.rows < 3) return false;
  const ColumnFacts& column = facts.columns[k];
  const bool others_smaller = facts.columns[k + 1].most < kTimes && facts.columns[k + 2].most < kTimes;
  if (column.rises && column.least >= kTimes && others_smaller) return true;
  const bool fractions = !facts.columns[k + 1].whole && !facts.columns[k + 2].whole;
  // With x y z r g b, the third number behind would be red.
  if (fractions && facts.columns[k + 3].whole && Triples(facts).colours(k + 3)) return false;
  if (!column.whole) return column.even;
  return column.counts || (column.strictly && fractions);
}

/// Whether two columns are the row and the column of a grid: whole numbers, of which one ends where the other
/// begins anew, ahead of fractions.
bool are_cell(const TableFacts& facts, std::size_t k) {
  if (k + 5 > facts.columns.size() || facts.rows < 3) return false;
  const auto whole = [&](std::size_t c) { return !facts.columns[c].text && facts.columns[c].whole; };
  const auto fraction = [&](std::size_t c) { return !facts.columns[c].text && !facts.columns[c].whole; };
  return whole(k) && whole(k + 1) && facts.columns[k].least >= 0 && facts.columns[k + 1].least >= 0 &&
         (facts.columns[k].rises || facts.columns[k + 1].rises) && fraction(k + 2) && fraction(k + 3) &&
         fraction(k + 4);
}

void name(std::vector<std::string>& names, std::size_t at, const char* const (&triple)[3]) {
  std::copy(triple, triple + 3, names.begin() + static_cast<std::ptrdiff_t>(at));
}

/// "1 to 3" or "4".
std::string range_text(std::size_t begin, std::size_t end) {
  const std::string first = std::to_string(begin + 1);
  return end - begin == 1 ? first : first + (end - begin == 2 ? " and " : " to ") + std::to_string(end);
}

}  // namespace

void ColumnFacts::add(double value, std::string_view word, bool first) {
  digits = std::max(digits, significant_digits(word));
  if (std::isnan(value)) {
    whole = counts = strictly = even = false;
    return;
  }
  whole = whole && std::floor(value) == value;
  single = single && double{to_float(value)} == value;
  if (!first) {
    rises = rises && value >= last;
    strictly = strictly && value > last;
    counts = counts && value == last + 1;
    constexpr double kUneven = 1e-3, kRounding = 1e-9;
    if (step == 0) step = value - last;
    even = even && step > 0 && std::abs(value - last - step) <= kUneven * step + kRounding * std::abs(value);
  }
  least = std::min(least, value);
  most = std::max(most, value);
  last = value;
}

void TableFacts::add(const std::vector<double>& values, const std::vector<std::string_view>& words) {
  constexpr double kUnit = 0.02;
  for (std::size_t k = 0; k < columns.size(); ++k)
    if (!columns[k].text) columns[k].add(values[k], words[k], rows == 0);
  unit.resize(columns.size(), 0);
  for (std::size_t k = 3; k + 2 < columns.size(); ++k) {
    const double square =
        values[k] * values[k] + values[k + 1] * values[k + 1] + values[k + 2] * values[k + 2];
    unit[k] += std::abs(square - 1) < kUnit ? 1 : 0;
  }
  ++rows;
}

std::vector<std::string> guessed_columns(const TableFacts& facts, bool counted) {
  std::vector<std::string> names(facts.columns.size());
  const Triples triples(facts);
  std::size_t first = 0;
  const auto numbers_behind = [&](std::size_t k) {
    return std::count_if(facts.columns.begin() + static_cast<std::ptrdiff_t>(k), facts.columns.end(),
                         [](const ColumnFacts& c) { return !c.text; });
  };
  const auto skip_text = [&] {
    while (first < names.size() && facts.columns[first].text) ++first;
  };
  skip_text();
  if (are_cell(facts, first)) first += 2;
  while (numbers_behind(first) >= 4 && first + 3 < names.size() && is_ahead(facts, first)) {
    ++first;
    if (!facts.columns[first].text) break;  // a second number only behind a word
    skip_text();
  }
  skip_text();
  if (first + 3 > names.size() || facts.columns[first + 1].text || facts.columns[first + 2].text)
    throw IoError("a line has fewer than three numbers side by side, and a point needs x, y and z");
  name(names, first, {"x", "y", "z"});
  const std::size_t behind = names.size() - first - 3;
  const bool intensity_first =
      behind == 4 && triples.colours(first + 4) && (counted || !triples.colours(first + 3));
  bool coloured = false, normals = false;
  for (std::size_t k = first + (intensity_first ? 4 : 3); k + 2 < names.size();) {
    if (!normals && triples.normals(k)) {
      name(names, k, {"nx", "ny", "nz"});
      normals = true;
    } else if (!coloured && triples.colours(k)) {
      name(names, k, {"r", "g", "b"});
      coloured = true;
    } else {
      ++k;
      continue;
    }
    k += 3;
  }
  return names;
}

std::string columns_text(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t begin = 0; begin < names.size();) {
    if (names[begin].empty()) {
      ++begin;
      continue;
    }
    std::size_t end = begin;
    std::string list;
    for (; end < names.size() && end < begin + 3 && !names[end].empty(); ++end) list += " " + names[end];
    text += (text.empty() ? "" : ", ") + std::string(end - begin == 1 ? "column " : "columns ") +
            range_text(begin, end) + " as" + list;
    begin = end;
  }
  return text;
}

std::string left_out_text(const std::vector<std::string>& names) {
  std::string text;
  std::size_t count = 0;
  for (std::size_t begin = 0; begin < names.size(); ++begin) {
    if (!names[begin].empty()) continue;
    std::size_t end = begin;
    while (end < names.size() && names[end].empty()) ++end;
    text += (text.empty() ? "" : ", ") + range_text(begin, end);
    count += end - begin;
    begin = end;
  }
  return text.empty() ? "" : (count == 1 ? "column " : "columns ") + text;
}

}  // namespace filmsticking::io
