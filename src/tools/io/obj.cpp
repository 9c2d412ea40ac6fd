// SPDX-License-Identifier: GPL-3.0-or-later
// By hand: CGAL 5.5 reads no colours, refuses files without faces, and takes an index one past the end.
#include <algorithm>
#include <cmath>

#include "codecs.h"
#include "io_error.h"
#include "text_scanner.h"

namespace filmsticking::io {
namespace {

/// Colours are from 0 to 1, but some writers have bytes.
std::vector<Colour> to_bytes(const std::vector<Point>& shares) {
  double most = 0;
  for (const Point& share : shares)
    for (const double x : share) most = std::max(most, x);
  const double scale = most > 1 ? 1 : 255;
  std::vector<Colour> colours(shares.size());
  for (std::size_t i = 0; i < shares.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const double byte = shares[i][k] * scale;
      colours[i][k] = static_cast<std::uint8_t>(byte >= 0 ? std::lround(std::min(byte, 255.0)) : 0);
    }
  return colours;
}

/// A face's corners, from zero. In the file they count from one, or backwards from the last vertex.
std::vector<std::int32_t> read_corners(TextScanner& line, std::size_t vertices) {
  std::vector<std::int32_t> corners;
  for (std::string_view word = line.word(); !word.empty(); word = line.word()) {
    long long index = 0;
    if (!parse_integer(word.substr(0, word.find('/')), index)) throw IoError("a face in it is not numbers");
    index += index < 0 ? static_cast<long long>(vertices) : -1;
    corners.push_back(corner_index(static_cast<double>(index)));
  }
  return corners;
}

}  // namespace

pcl::PolygonMesh decode_obj(std::string_view bytes) {
  std::vector<Point> positions;
  std::vector<Point> colours;
  std::vector<Triangle> triangles;
  TextScanner file(bytes);
  std::size_t number = 0;
  for (std::string_view text; file.line(text);) {
    ++number;
    TextScanner line(text, TextScanner::kBlanks);
    const std::string_view keyword = line.word();
    if (keyword == "v") {
      Point p{};
      for (double& x : p)
        if (!line.number(x)) throw IoError("line " + std::to_string(number) + " is not a vertex");
      positions.push_back(p);
      std::vector<double> more;
      for (double x; line.remaining() > 0 && line.number(x);) more.push_back(x);
      if (const std::size_t n = more.size(); n >= 3)  // a fourth number alone is a weight
        colours.push_back({more[n - 3], more[n - 2], more[n - 1]});
    } else if (keyword == "f") {
      append_polygon(read_corners(line, positions.size()), triangles);
    }
  }
  if (colours.size() != positions.size()) colours.clear();
  check_corners(triangles, positions.size());
  return make_mesh(make_cloud(positions, to_bytes(colours)), triangles);
}

void encode_obj(const pcl::PCLPointCloud2& vertices, const std::vector<Triangle>& triangles,
                ByteWriter& out) {
  const PositionFields positions(vertices);
  const std::vector<Colour> colours = colours_of(vertices);
  for (std::size_t i = 0; i < size_of(vertices); ++i)
    out.add([&](std::string& text) {
      text += "v";
      for (const double x : positions.load(bytes_of(vertices, i))) {
        text += ' ';
        append_number(text, x);  // as double: readers may take the text for either precision
      }
      if (!colours.empty())
        for (const std::uint8_t channel : colours[i]) {
          text += ' ';
          append_number(text, static_cast<float>(channel) / 255);
        }
      text += '\n';
    });
  for (const Triangle& triangle : triangles)
    out.add([&](std::string& text) {
      text += "f";
      for (const std::int32_t corner : triangle) {
        text += ' ';
        append_number(text, corner + 1);
      }
      text += '\n';
    });
}

}  // namespace filmsticking::io
