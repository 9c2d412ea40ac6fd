// SPDX-License-Identifier: GPL-3.0-or-later
#include "strict_pcd.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "capture_error.h"

namespace filmsticking::capture {
namespace {

using Words = std::vector<std::string_view>;

[[noreturn]] void refuse(const std::string& what) { throw CaptureError("it is no strict PCD file: " + what); }

/// The bytes up to the next line end, which is taken too.
std::string_view take_line(std::string_view& bytes) {
  const std::size_t end = bytes.find('\n');
  if (end == std::string_view::npos) refuse("it ends too early");
  std::string_view line = bytes.substr(0, end);
  bytes.remove_prefix(end + 1);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

Words words_of(std::string_view line) {
  constexpr std::string_view kBlanks = " \t";
  Words words;
  for (std::size_t at = line.find_first_not_of(kBlanks); at != std::string_view::npos;
       at = line.find_first_not_of(kBlanks, at)) {
    const std::size_t end = std::min(line.find_first_of(kBlanks, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = end;
  }
  return words;
}

template <typename Number>
bool parse(std::string_view word, Number& number) {
  const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc() && rest == word.data() + word.size();
}

std::size_t parse_count(std::string_view word, std::size_t most) {
  std::size_t count = 0;
  if (!parse(word, count) || count > most) refuse("'" + std::string(word) + "' is no count");
  return count;
}

/// The header's lines in their order.
class HeaderReader {
 public:
  explicit HeaderReader(std::string_view& bytes) : bytes_(bytes) { advance(); }

  bool is(std::string_view keyword) const { return words_[0] == keyword; }

  /// The words behind the keyword of the next line.
  Words take(std::string_view keyword) {
    if (!is(keyword)) refuse(std::string(keyword) + " is not where it belongs");
    Words values(words_.begin() + 1, words_.end());
    if (keyword != "DATA") advance();
    return values;
  }

  Words take(std::string_view keyword, std::size_t count) {
    Words values = take(keyword);
    if (values.size() != count)
      refuse(std::string(keyword) + " has not " + std::to_string(count) + " value" + (count == 1 ? "" : "s"));
    return values;
  }

 private:
  /// PCL's reader takes a line of blanks, unlike one of nothing, for the header's end and goes on without a
  /// header.
  void advance() {
    do {
      const bool nothing = bytes_.substr(0, 1) == "\n";
      words_ = words_of(take_line(bytes_));
      if (words_.empty() && !nothing) refuse("a line of its header is blank");
    } while (words_.empty() || words_[0][0] == '#');
  }

  std::string_view& bytes_;
  Words words_;
};

/// Every point is a line, with as many words as it has numbers.
void check_text(std::string_view body, std::size_t points, std::size_t numbers) {
  std::size_t lines = 0;
  while (!body.empty()) {
    const std::size_t end = std::min(body.find('\n'), body.size());
    std::string_view line = body.substr(0, end);
    body.remove_prefix(std::min(end + 1, body.size()));
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    const std::size_t words = words_of(line).size();
    if (words == 0) continue;
    if (words != numbers) refuse("a point has " + std::to_string(words) + " numbers");
    ++lines;
  }
  if (lines != points) refuse("it has " + std::to_string(lines) + " points");
}

/// PCL's reader does not end the header at DATA: a keyword behind it, past comments and empty lines, counts
/// too, and then sizes change after the memory for them was taken.
void check_header_ends(std::string_view body) {
  for (bool header = true; header && !body.empty();) {
    std::string_view line = body.substr(0, body.find('\n'));
    body.remove_prefix(std::min(line.size() + 1, body.size()));
    line.remove_prefix(std::min(line.find_first_not_of(" \t\r\v\f"), line.size()));
    for (const std::string_view keyword : {"VERSION", "FIELDS", "COLUMNS", "SIZE", "TYPE", "COUNT", "WIDTH",
                                           "HEIGHT", "VIEWPOINT", "POINTS", "DATA"})
      if (line.substr(0, keyword.size()) == keyword) refuse("its header goes on behind DATA");
    header = line.empty() || line[0] == '#';
  }
}

}  // namespace

void check_pcd(std::string_view bytes) {
  constexpr std::size_t kMostPoints = INT32_MAX, kMostFields = 1000, kMostCount = 100000;
  std::string_view rest = bytes;
  HeaderReader header(rest);
  header.take("VERSION", 1);
  const Words fields = header.take("FIELDS");
  if (fields.empty() || fields.size() > kMostFields) refuse("it has no fields");
  const Words sizes = header.take("SIZE", fields.size());
  const Words types = header.take("TYPE", fields.size());
  const Words counts = header.is("COUNT") ? header.take("COUNT", fields.size()) : Words(fields.size(), "1");
  const std::size_t width = parse_count(header.take("WIDTH", 1)[0], kMostPoints);
  const std::size_t height = parse_count(header.take("HEIGHT", 1)[0], kMostPoints);
  if (header.is("VIEWPOINT"))
    for (const std::string_view word : header.take("VIEWPOINT", 7)) {
      double number = 0;
      if (!parse(word, number) || !std::isfinite(number)) refuse("its VIEWPOINT is not seven numbers");
    }
  const std::size_t points = parse_count(header.take("POINTS", 1)[0], kMostPoints);
  const std::string_view data = header.take("DATA", 1)[0];
  if (points == 0 || width * height != points) refuse("WIDTH times HEIGHT is not POINTS");

  std::size_t step = 0, numbers = 0;
  for (std::size_t f = 0; f < fields.size(); ++f) {
    const std::size_t size = parse_count(sizes[f], 8), count = parse_count(counts[f], kMostCount);
    const bool real = types[f] == "F" && (size == 4 || size == 8);
    const bool whole =
        (types[f] == "I" || types[f] == "U") && (size == 1 || size == 2 || size == 4 || size == 8);
    if ((!real && !whole) || count == 0)
      refuse("its field '" + std::string(fields[f]) + "' has an unknown type");
    step += size * count;
    numbers += count;
  }
  check_header_ends(rest);
  if (data == "ascii") return check_text(rest, points, numbers);
  if (data == "binary") {
    if (rest.size() < points * step) refuse("it ends too early");
    return;
  }
  if (data != "binary_compressed") refuse("its DATA is unknown");
  std::uint32_t compressed = 0, size = 0;
  if (rest.size() < 8) refuse("it ends too early");
  std::memcpy(&compressed, rest.data(), 4);
  std::memcpy(&size, rest.data() + 4, 4);
  if (compressed > rest.size() - 8 || size != points * step) refuse("its data are not as long as its points");
}

}  // namespace filmsticking::capture
