// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>

#include "codecs.h"
#include "io_error.h"
#include "text_scanner.h"

namespace filmsticking::io {
namespace {

bool is_comment(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(" \t");
  return begin == std::string_view::npos || line[begin] == '#' || line.substr(begin, 2) == "//";
}

/// The next three words as a colour.
bool read_colour(TextScanner& line, Colour& colour) {
  for (std::uint8_t& channel : colour) {
    long long value = 0;
    if (!parse_integer(line.word(), value) || value < 0 || value > 255) return false;
    channel = static_cast<std::uint8_t>(value);
  }
  return true;
}

}  // namespace

Cloud decode_xyz(std::string_view bytes) {
  std::vector<Point> positions;
  std::vector<Colour> colours;
  bool coloured = true;
  std::uint8_t brightest = 0;
  TextScanner file(bytes);
  std::size_t number = 0;
  for (std::string_view text; file.line(text);) {
    ++number;
    if (is_comment(text)) continue;
    TextScanner line(text);
    Point p{};
    if (!line.number(p[0]) || !line.number(p[1]) || !line.number(p[2])) {
      if (positions.empty()) continue;
      throw IoError("line " + std::to_string(number) + " does not begin with three numbers");
    }
    positions.push_back(p);
    Colour colour{};
    coloured = coloured && read_colour(line, colour);
    if (!coloured) continue;
    colours.push_back(colour);
    brightest = std::max({brightest, colour[0], colour[1], colour[2]});
  }
  if (!coloured || brightest < 2) colours.clear();
  return {make_cloud(positions, colours), std::nullopt};
}

}  // namespace filmsticking::io
