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

void encode_xyz(const Cloud& cloud, ByteWriter& out) {
  const PositionFields positions(cloud.points);
  std::vector<const pcl::PCLPointField*> normal;
  for (const char* name : {"normal_x", "normal_y", "normal_z"})
    if (const pcl::PCLPointField* field = find_field(cloud.points, name))
      if (field->datatype == pcl::PCLPointField::FLOAT32) normal.push_back(field);
  if (normal.size() != 3) normal.clear();
  for (std::size_t i = 0; i < size_of(cloud.points); ++i)
    out.add([&](std::string& text) {
      const std::uint8_t* point = bytes_of(cloud.points, i);
      const Point place = positions.load(point);
      for (int axis = 0; axis < 3; ++axis) {
        if (axis > 0) text += ' ';
        append_number(text, place[static_cast<std::size_t>(axis)]);
      }
      for (const pcl::PCLPointField* field : normal) {
        text += ' ';
        append_number(text, load<float>(point + field->offset));
      }
      text += '\n';
    });
}

}  // namespace filmsticking::io
