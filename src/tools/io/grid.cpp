// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <map>
#include <string>

#include "codecs.h"
#include "io_error.h"
#include "text_scanner.h"
#include "text_table.h"

namespace filmsticking::io {
namespace {}  // namespace

Cloud decode_grid(std::string_view bytes) {
  std::string buffer;
  const std::string_view text = plain_text(bytes, buffer);
  TextScanner scanner(text, TextScanner::kBlanks);
  std::map<std::string, double> header = {{"nodata_value", -9999}};
  std::string_view word = scanner.word();
  for (double first = 0; !word.empty() && !parse_number(word, first); word = scanner.word()) {
    double value = 0;
    const std::string_view number = scanner.word();
    if (!parse_number(number, value)) throw_no_number(text, number.empty() ? word : number);
    header[lower(word)] = value;
  }
  const auto value_of = [&](const char* name) {
    const auto found = header.find(name);
    if (found == header.end()) throw IoError(std::string("its header has no ") + name);
    return found->second;
  };
  const double columns = value_of("ncols"), rows = value_of("nrows"), cell = value_of("cellsize");
  if (!(columns >= 1 && rows >= 1 && std::floor(columns) == columns && std::floor(rows) == rows) ||
      columns > static_cast<double>(text.size()) / rows)
    throw IoError("its ncols and nrows are not the size of its grid");
  const auto corner = [&](const char* of_corner, const char* of_centre) {
    return header.count(of_centre) ? header[of_centre] : value_of(of_corner) + cell / 2;
  };
  const double left = corner("xllcorner", "xllcenter"), low = corner("yllcorner", "yllcenter");
  const double none = header["nodata_value"];
  const auto wide = static_cast<std::size_t>(columns), high = static_cast<std::size_t>(rows);
  std::vector<Point> points;
  for (std::size_t i = 0; i < wide * high; ++i, word = scanner.word()) {
    double z = 0;
    if (word.empty()) throw IoError("it has fewer heights than its header says");
    if (!parse_number(word, z)) throw_no_number(text, word);
    if (z == none || !std::isfinite(z)) continue;
    const std::size_t row = i / wide;
    points.push_back(
        {left + cell * static_cast<double>(i % wide), low + cell * static_cast<double>(high - 1 - row), z});
  }
  if (!word.empty()) throw IoError("it has more heights than its header says");
  Cloud cloud{make_cloud(points)};
  if (points.size() < wide * high)
    cloud.notes.push_back("left out " + std::to_string(wide * high - points.size()) +
                          " of its cells, which have no height");
  return cloud;
}

}  // namespace filmsticking::io
