// SPDX-License-Identifier: GPL-3.0-or-later
#include "text_scanner.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <string>

namespace filmsticking::io {
namespace {

/// from_chars() knows no leading plus.
std::string_view without_plus(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  return word;
}

/// The number as from_chars() knows it; empty if it is none.
std::string plain_number(std::string_view word) {
  const bool negative = word[0] == '-';
  const std::string_view rest = word.substr(negative || word[0] == '+' ? 1 : 0);
  for (const std::string_view none : {"nan(", "1.#QNAN", "1.#SNAN", "1.#IND"})
    if (rest.substr(0, none.size()) == none) return "nan";
  if (rest == "NA" || rest == "N/A" || rest == "null") return "nan";
  if (rest.substr(0, 6) == "1.#INF") return negative ? "-inf" : "inf";
  std::string text(word);
  std::replace(text.begin(), text.end(), ',', '.');
  for (char& c : text)
    if (c == 'd' || c == 'D') c = 'e';
  return std::count(text.begin(), text.end(), '.') <= 1 ? text : "";
}

float out_of_range(const char* word, float) { return std::strtof(word, nullptr); }
double out_of_range(const char* word, double) { return std::strtod(word, nullptr); }

template <typename T>
bool parse_plain(std::string_view word, T& value) {
  const std::string_view text = without_plus(word);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || end != text.data() + text.size()) return false;
  if (error == std::errc::result_out_of_range) value = out_of_range(std::string(text).c_str(), T());
  return error != std::errc::invalid_argument;
}

}  // namespace

bool TextScanner::line(std::string_view& line) {
  if (rest_.empty()) return false;
  if (end_ == 0) {
    const std::size_t feed = rest_.find('\n'), back = rest_.substr(0, feed).find('\r');
    end_ = back != std::string_view::npos && back + 1 != feed ? '\r' : '\n';
  }
  const std::size_t end = rest_.find(end_);
  line = rest_.substr(0, end);
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return true;
}

std::string_view TextScanner::word() {
  const std::size_t begin = rest_.find_first_not_of(separators_);
  if (begin == std::string_view::npos) {
    rest_ = {};
    return {};
  }
  rest_.remove_prefix(begin);
  const std::string_view word = rest_.substr(0, rest_.find_first_of(separators_));
  rest_.remove_prefix(word.size());
  return word;
}

template <typename T>
bool parse_number(std::string_view word, T& value) {
  constexpr std::size_t kMost = 100;  // longer words with odd letters are no numbers
  if (parse_plain(word, value)) return true;
  if (word.empty() || word.size() > kMost) return false;
  const std::string plain = plain_number(word);
  return !plain.empty() && plain != word && parse_plain(std::string_view(plain), value);
}

template bool parse_number(std::string_view, float&);
template bool parse_number(std::string_view, double&);

template <typename T>
bool TextScanner::number(T& value) {
  return parse_number(word(), value);
}

template bool TextScanner::number(float&);
template bool TextScanner::number(double&);

std::size_t line_number(std::string_view text, std::size_t at) {
  text = text.substr(0, at);
  const auto count = [&](char end) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), end));
  };
  const std::size_t lines = count('\n');
  return 1 + (lines > 0 ? lines : count('\r'));
}

bool parse_integer(std::string_view word, long long& value) {
  word = without_plus(word);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

}  // namespace filmsticking::io
