// SPDX-License-Identifier: GPL-3.0-or-later
#include "text_table.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include "io_error.h"
#include "text_scanner.h"

namespace filmsticking::io {
namespace {

constexpr std::string_view kBlanks = " \t\v\f\r";
constexpr std::string_view kAround = " \t\v\f\r\"'[](){}";
constexpr std::size_t kSample = 1000;  // lines that the style is taken from

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string_view trimmed(std::string_view word, std::string_view edge) {
  const std::size_t begin = word.find_first_not_of(edge);
  if (begin == std::string_view::npos) return {};
  return word.substr(begin, word.find_last_not_of(edge) - begin + 1);
}

/// UTF-16 to UTF-8, where all that is not ASCII becomes '?'. No number and no name of a column needs it.
std::string narrowed(std::string_view bytes, bool big_endian) {
  std::string text;
  text.reserve(bytes.size() / 2);
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    const char low = bytes[i + (big_endian ? 1 : 0)], high = bytes[i + (big_endian ? 0 : 1)];
    text += high == 0 && low > 0 ? low : '?';
  }
  return text;
}

/// Without a byte-order mark, every other byte of ASCII in UTF-16 is zero.
bool looks_like_utf16(std::string_view bytes, bool big_endian) {
  if (bytes.size() < 4) return false;
  const std::size_t most = std::min<std::size_t>(bytes.size() & ~std::size_t{1}, 64);
  for (std::size_t i = 0; i < most; i += 2)
    if (bytes[i + (big_endian ? 0 : 1)] != 0 || bytes[i + (big_endian ? 1 : 0)] == 0) return false;
  return true;
}

/// What is between blanks, semicolons and the ends of quotes, for a first look at commas.
template <class Use>
void each_chunk(std::string_view line, const Use& use) {
  bool quoted = false;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    const char c = i < line.size() ? line[i] : ' ';
    if (c == '"') quoted = !quoted;
    const bool ends = i == line.size() || c == '"' || c == ';' ||
                      (!quoted && kBlanks.find(c) != std::string_view::npos) ||
                      (c == ',' && !quoted && i > 0 && line[i - 1] == '"');
    if (!ends) continue;
    const std::string_view chunk = trimmed(line.substr(begin, i - begin), kAround);
    if (!chunk.empty()) use(chunk);
    begin = i + 1;
  }
}

/// Digits in groups of three, as in "1 234 567,8".
bool is_grouped(std::string_view field) {
  if (!field.empty() && (field[0] == '-' || field[0] == '+')) field.remove_prefix(1);
  field = field.substr(0, field.find_first_of(".,"));
  std::size_t group = field.find(' ');
  if (group < 1 || group > 3) return false;
  for (std::size_t begin = 0; begin < field.size(); begin += group + 1, group = 3) {
    const std::string_view digits = field.substr(begin, group);
    if (digits.size() != group || !std::all_of(digits.begin(), digits.end(), is_digit)) return false;
    if (begin + group < field.size() && field[begin + group] != ' ') return false;
  }
  return true;
}

/// What a sample of lines with numbers has between them.
struct Evidence {
  std::size_t lines = 0, semicolons = 0, tabs = 0, commas = 0;  // lines with two of them at least
  bool points = false;                                          // a number with a decimal point
  bool thousands = false;                                       // "1,234.5"
  bool both_in_word = false;                                    // "1.234,5"
  bool decimal_words = true;   // each word has at most one comma, between digits
  bool inner_blanks = false;   // numbers with only blanks between them, beside other separators
  bool leading_zeros = false;  // behind a comma, as in "0,05"
  std::size_t fewest_words = std::numeric_limits<std::size_t>::max();
  bool has_comma = false;
  bool quoted_words = false;  // commas between quotes, as in "0,5","1,5"
  bool groups = false;        // "1 234 567" between other separators

  void add(std::string_view line);
};

void Evidence::add(std::string_view line) {
  const auto count = [&](char c) { return std::count(line.begin(), line.end(), c); };
  ++lines;
  quoted_words |= line.find("\",") != std::string_view::npos;
  semicolons += count(';') >= 2 ? 1 : 0;
  tabs += count('\t') >= 2 ? 1 : 0;
  commas += count(',') >= 2 ? 1 : 0;
  std::size_t words = 0;
  each_chunk(line, [&](std::string_view word) {
    const std::size_t comma = word.find(','), point = word.find('.');
    const bool number = std::any_of(word.begin(), word.end(), is_digit);
    ++words;
    points |= number && point != std::string_view::npos && comma == std::string_view::npos;
    if (comma == std::string_view::npos) return;
    has_comma = true;
    const bool single = word.find(',', comma + 1) == std::string_view::npos;
    const bool between = comma + 1 < word.size() && is_digit(word[comma + 1]);
    decimal_words &= single && between && number;
    if (!single || !between) points |= point != std::string_view::npos;
    if (single && between && point != std::string_view::npos) {
      if (point < comma) both_in_word = true;
      thousands |= point == comma + 4;
      points = true;
    }
    for (std::size_t at = comma; at != std::string_view::npos; at = word.find(',', at + 1))
      leading_zeros |= at + 2 < word.size() && word[at + 1] == '0' && is_digit(word[at + 2]);
  });
  fewest_words = std::min(fewest_words, words);
  const auto fields_with_blanks = [&](char separator) {
    while (true) {
      const std::size_t end = line.find(separator);
      const std::string_view field = trimmed(line.substr(0, end), kAround);
      const std::size_t blank = field.find_first_of(" \t");
      if (blank != std::string_view::npos && number_of(field.substr(0, blank))) inner_blanks = true;
      groups |= blank != std::string_view::npos && is_grouped(field);
      if (end == std::string_view::npos) return;
      line.remove_prefix(end + 1);
    }
  };
  fields_with_blanks(semicolons > 0 ? ';' : commas > 0 ? ',' : '\t');
}

bool has_two_numbers(std::string_view line) {
  int numbers = 0;
  bool in_word = false;
  for (const char c : line) {
    const bool separates = std::string_view(" \t,;\v\f\r[](){}\"'").find(c) != std::string_view::npos;
    if (!separates && !in_word && (is_digit(c) || c == '-' || c == '+' || c == '.')) ++numbers;
    in_word = !separates;
  }
  return numbers >= 2;
}

[[noreturn]] void refuse_commas(const char* why) {
  throw IoError(std::string("its commas may be decimal points or separators: ") + why +
                "; write numbers with points, or separate them with semicolons");
}

TextStyle chosen(const Evidence& seen) {
  TextStyle style;
  const bool most_semicolons = 2 * seen.semicolons > seen.lines;
  if (seen.has_comma && seen.thousands && seen.fewest_words >= 3)
    refuse_commas("there is a number like 1,234.5");
  if (seen.both_in_word && seen.fewest_words >= 3) refuse_commas("there is a number like 1.234,5");
  if (seen.groups && most_semicolons)
    throw IoError("there is a number like 1 234 567; write numbers without blanks between their digits");
  const bool decimal_commas = seen.has_comma && !seen.points && seen.decimal_words && seen.fewest_words >= 3;
  const bool separating_commas = seen.has_comma && !decimal_commas;
  if (separating_commas && !seen.points && seen.leading_zeros && !most_semicolons)
    refuse_commas("there is 0 behind one");
  style.decimal_commas = decimal_commas;
  if (seen.quoted_words || (separating_commas && !seen.inner_blanks && 2 * seen.commas > seen.lines)) {
    style.separator = ',';
  } else if (most_semicolons && !seen.inner_blanks) {
    style.separator = ';';
  } else if (!separating_commas && !seen.inner_blanks && 2 * seen.tabs > seen.lines) {
    style.separator = '\t';
  }
  style.commas_too = separating_commas;
  return style;
}

void split_at(std::string_view line, char separator, std::vector<std::string_view>& words) {
  std::size_t begin = 0;
  bool quoted = false;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    if (i < line.size() && line[i] == '"') quoted = !quoted;
    if (i < line.size() && (quoted || line[i] != separator)) continue;
    const std::string_view word = trimmed(line.substr(begin, i - begin), kAround);
    if (i < line.size() || !word.empty()) words.push_back(word);  // nothing behind the last separator
    begin = i + 1;
  }
}

/// Which bytes are in a set.
class ByteSet {
 public:
  explicit ByteSet(std::string_view members) {
    for (const char c : members) in_[static_cast<unsigned char>(c)] = true;
  }
  bool has(char c) const { return in_[static_cast<unsigned char>(c)]; }

 private:
  bool in_[256] = {};
};

void split_at_blanks(std::string_view line, std::size_t number, bool commas_too,
                     std::vector<std::string_view>& words) {
  static const ByteSet without_commas(" \t\v\f\r\"'[](){};"), with_commas(" \t\v\f\r\"'[](){};,");
  const ByteSet& separators = commas_too ? with_commas : without_commas;
  std::size_t marks = 0;  // commas and semicolons since the last word
  std::size_t begin = std::string_view::npos;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    const char c = i < line.size() ? line[i] : ' ';
    const bool in_word = begin != std::string_view::npos;
    if (!separators.has(c)) {
      if (in_word) continue;
      if (marks > 1) throw IoError("line " + std::to_string(number) + " has separators with nothing between");
      begin = i;
      continue;
    }
    if (in_word &&
        (c == '(' || (c == ')' && line.substr(begin, i - begin).find('(') != std::string_view::npos)))
      continue;  // nan(ind)
    if (in_word) words.push_back(line.substr(begin, i - begin)), marks = 0;
    begin = std::string_view::npos;
    marks += c == ',' || c == ';' ? 1 : 0;
  }
}

}  // namespace

std::string_view plain_text(std::string_view bytes, std::string& buffer) {
  const auto begins = [&](std::string_view mark) { return bytes.substr(0, mark.size()) == mark; };
  if (begins(std::string_view("\xff\xfe\0\0", 4)) || begins(std::string_view("\0\0\xfe\xff", 4)))
    throw IoError("it is text in UTF-32; save it as UTF-8");
  if (begins("\xef\xbb\xbf")) bytes.remove_prefix(3);
  const bool little = begins("\xff\xfe"), big = begins("\xfe\xff");
  if (little || big || looks_like_utf16(bytes, false) || looks_like_utf16(bytes, true)) {
    buffer = narrowed(bytes.substr(little || big ? 2 : 0), big || (!little && bytes[0] == 0));
    bytes = buffer;
  }
  if (bytes.find('\0') != std::string_view::npos) throw IoError("it is no text, and no format that is known");
  return bytes;
}

Lines::Lines(std::string_view text) : rest_(text) {
  const std::size_t feed = text.find('\n'), back = text.substr(0, feed).find('\r');
  end_ = back != std::string_view::npos && back + 1 != feed ? '\r' : '\n';
}

bool Lines::next(std::string_view& line) {
  if (rest_.empty()) return false;
  const auto* const at = static_cast<const char*>(std::memchr(rest_.data(), end_, rest_.size()));
  line = at ? rest_.substr(0, static_cast<std::size_t>(at - rest_.data())) : rest_;
  rest_.remove_prefix(std::min(line.size() + 1, rest_.size()));
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  ++number_;
  return true;
}

bool is_comment(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(kBlanks);
  return begin == std::string_view::npos || line[begin] == '#' || line[begin] == '%' || line[begin] == '!' ||
         line.substr(begin, 2) == "//";
}

namespace {

/// "#ff8000", with alpha or without.
bool is_web_colour(std::string_view word) {
  word = word.substr(0, word.find_first_of(" \t,;\"\r"));
  return (word.size() == 7 || word.size() == 9) &&
         word.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string_view::npos;
}

}  // namespace

std::string_view without_comment(std::string_view line) {
  for (std::size_t at = 0; at < line.size(); ++at) {
    if (line[at] != '#' && line[at] != '/') continue;
    const bool mark = (line[at] == '#' && !is_web_colour(line.substr(at))) || line.substr(at, 2) == "//";
    const bool begins_word =
        at == 0 || std::string_view(" \t,;").find(line[at - 1]) != std::string_view::npos;
    if (mark && begins_word) return line.substr(0, at);
  }
  return line;
}

void split(std::string_view line, std::size_t number, const TextStyle& style,
           std::vector<std::string_view>& words) {
  words.clear();
  style.separator ? split_at(line, style.separator, words)
                  : split_at_blanks(line, number, style.commas_too, words);
}

std::optional<double> number_of(std::string_view word) {
  double value = 0;
  if (word.empty()) return std::numeric_limits<double>::quiet_NaN();
  if (!parse_number(word, value)) return std::nullopt;
  return value;
}

TextStyle style_of(std::string_view text) {
  Evidence seen;
  Lines lines(text);
  for (std::string_view line; seen.lines < kSample && lines.next(line);)
    if (!is_comment(line) && has_two_numbers(line)) seen.add(without_comment(line));
  return chosen(seen);
}

}  // namespace filmsticking::io
