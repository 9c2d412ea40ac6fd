// SPDX-License-Identifier: GPL-3.0-or-later
#include "text_scanner.h"

#include <charconv>
#include <cstdlib>
#include <string>

namespace filmsticking::io {
namespace {

constexpr std::string_view kSeparators = " \t\r\n\v\f,;";

/// from_chars() knows no leading plus.
std::string_view without_plus(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  return word;
}

float out_of_range(const char* word, float) { return std::strtof(word, nullptr); }
double out_of_range(const char* word, double) { return std::strtod(word, nullptr); }

}  // namespace

bool TextScanner::line(std::string_view& line) {
  if (rest_.empty()) return false;
  const std::size_t end = rest_.find('\n');
  line = rest_.substr(0, end);
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return true;
}

std::string_view TextScanner::word() {
  const std::size_t begin = rest_.find_first_not_of(kSeparators);
  if (begin == std::string_view::npos) {
    rest_ = {};
    return {};
  }
  rest_.remove_prefix(begin);
  const std::string_view word = rest_.substr(0, rest_.find_first_of(kSeparators));
  rest_.remove_prefix(word.size());
  return word;
}

template <typename T>
bool parse_number(std::string_view word, T& value) {
  const std::string_view text = without_plus(word);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || end != text.data() + text.size()) return false;
  if (error == std::errc::result_out_of_range) value = out_of_range(std::string(text).c_str(), T());
  return error != std::errc::invalid_argument;
}

template bool parse_number(std::string_view, float&);
template bool parse_number(std::string_view, double&);

template <typename T>
bool TextScanner::number(T& value) {
  return parse_number(word(), value);
}

template bool TextScanner::number(float&);
template bool TextScanner::number(double&);

bool parse_integer(std::string_view word, long long& value) {
  word = without_plus(word);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

}  // namespace filmsticking::io
