// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>

namespace filmsticking::io {

/// Takes words and numbers off the front of a text. Blanks separate, and so do commas and semicolons.
class TextScanner {
 public:
  explicit TextScanner(std::string_view text) : rest_(text) {}

  /// The next line without its end ("\n" or "\r\n"); false at the end of the text.
  bool line(std::string_view& line);

  /// The next word, past any line ends; empty at the end of the text.
  std::string_view word();

  /// The next word as a number, rounded once to T (float or double); "nan" and "inf" are numbers.
  /// False if there is none; the word is taken either way.
  template <typename T>
  bool number(T& value);

  std::size_t remaining() const { return rest_.size(); }

 private:
  std::string_view rest_;
};

/// The whole of `word` as a whole number.
bool parse_integer(std::string_view word, long long& value);

}  // namespace filmsticking::io
