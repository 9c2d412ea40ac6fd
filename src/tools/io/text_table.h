// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of numbers as text, whatever separates them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace filmsticking::io {

/// How the words of a line are separated.
struct TextStyle {
  char separator = 0;  ///< one between two words, so that a word may be empty; 0: blanks, any number of them
  bool commas_too = false;      ///< with blanks, commas separate as well
  bool decimal_commas = false;  ///< commas are decimal points
};

/// The text in UTF-8 without a byte-order mark: `bytes` itself, or `buffer`, to which UTF-16 is converted.
/// Throws IoError for bytes that are no text.
std::string_view plain_text(std::string_view bytes, std::string& buffer);

/// The lines of a text, each with its number; ends are "\n", "\r\n" or "\r".
class Lines {
 public:
  explicit Lines(std::string_view text);

  /// The next line; false at the end.
  bool next(std::string_view& line);

  std::size_t number() const { return number_; }  ///< of the line that next() gave, from 1

 private:
  std::string_view rest_;
  char end_;
  std::size_t number_ = 0;
};

/// Whether the line has nothing but a comment ("#", "//", "%", "!"), or nothing.
bool is_comment(std::string_view line);

/// The line without a comment at its end.
std::string_view without_comment(std::string_view line);

/// The words of a line, without blanks, quotes and brackets around them. Throws IoError, with the line's
/// number, where that many separators stand side by side that a word may be missing.
void split(std::string_view line, std::size_t number, const TextStyle& style,
           std::vector<std::string_view>& words);

/// A word as a number; none if it is none. An empty word is a number that is missing: not a number.
std::optional<double> number_of(std::string_view word);

/// The style of the lines with numbers. Throws IoError where commas could be both, points and separators.
TextStyle style_of(std::string_view text);

}  // namespace filmsticking::io
