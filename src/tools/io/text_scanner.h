// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>

namespace filmsticking::io {

/// Latin letters of a word in lower case.
inline std::string lower(std::string_view word) {
  std::string text(word);
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

/// Takes words and numbers from the front of a text.
class TextScanner {
 public:
  static constexpr std::string_view kBlanks = " \t\r\n\v\f";
  static constexpr std::string_view kBlanksAndCommas = " \t\r\n\v\f,;";

  /// `separators`: what separates words.
  explicit TextScanner(std::string_view text, std::string_view separators = kBlanksAndCommas)
      : rest_(text), separators_(separators) {}

  /// The next line without its end ("\n", "\r\n", or "\r" where the first line ends so); false at the end of
  /// the text.
  bool line(std::string_view& line);

  /// The next word, past any line ends; empty at the end of the text.
  std::string_view word();

  /// The next word as a number, rounded once to T (float or double); "nan" and "inf" are numbers.
  /// False if there is none; the word is taken either way.
  template <typename T>
  bool number(T& value);

  std::size_t remaining() const { return rest_.size(); }

 private:
  std::string_view rest_, separators_;
  char end_ = 0;  // of lines; 0 before the first
};

/// The number of the line at this byte of a text, from 1.
std::size_t line_number(std::string_view text, std::size_t at);

/// The whole of `word` as a whole number.
bool parse_integer(std::string_view word, long long& value);

/// The whole of `word` as a number, rounded once to T (float or double). Also as other languages write it:
/// a decimal comma, Fortran's exponent d, "1.#QNAN" and "-nan(ind)".
template <typename T>
bool parse_number(std::string_view word, T& value);

/// Appends the shortest text that reads back as the same number.
template <typename Number>
void append_number(std::string& text, Number number) {
  char digits[64];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr);
}

}  // namespace filmsticking::io
