// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>

namespace filmsticking::io {

/// Takes words and numbers from the front of a text. Blanks, commas and semicolons separate words.
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

/// The whole of `word` as a number, rounded once to T (float or double).
template <typename T>
bool parse_number(std::string_view word, T& value);

/// Appends the shortest text that reads back as the same number.
template <typename Number>
void append_number(std::string& text, Number number) {
  char digits[64];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
}

}  // namespace filmsticking::io
