// SPDX-License-Identifier: GPL-3.0-or-later
// What the columns of a table are, from their numbers alone.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace filmsticking::io {

/// What the numbers of a column have in common.
struct ColumnFacts {
  bool text = false;     ///< its first word is no number
  bool whole = true;     ///< whole numbers
  bool single = true;    ///< floats keep every value
  bool rises = true;     ///< none is smaller than the one before
  bool strictly = true;  ///< each is larger than the one before
  bool counts = true;    ///< each is one more than the one before
  bool even = true;      ///< each is as much more than the one before as the second than the first
  int digits = 0;        ///< most significant digits of a word
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
  double last = 0, step = 0;  ///< the last one, and the second less the first

  void add(double value, std::string_view word, bool first);
};

/// The facts of all columns.
struct TableFacts {
  std::vector<ColumnFacts> columns;
  std::vector<std::size_t> unit;  ///< rows in which the columns k, k + 1, k + 2 are a vector of length 1
  std::size_t rows = 0;

  /// Adds a row of numbers; those of text columns do not count.
  void add(const std::vector<double>& values, const std::vector<std::string_view>& words);
};

/// The names of columns without a header: x y z, then "r g b", "nx ny nz", or nothing for what is not known;
/// a leading number of the point or time is none. `counted`: the file begins with its number of points, as
/// PTS does, whose colours stand behind an intensity. Throws IoError for fewer than three columns of numbers.
std::vector<std::string> guessed_columns(const TableFacts& facts, bool counted);

/// "columns 1 to 3 as x y z, column 4 as intensity" of the names, without those that are empty.
std::string columns_text(const std::vector<std::string>& names);

/// "column 4", "columns 4 to 6, 9" of those that are empty; empty if there are none.
std::string left_out_text(const std::vector<std::string>& names);

}  // namespace filmsticking::io
