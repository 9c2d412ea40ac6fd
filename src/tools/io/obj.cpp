// SPDX-License-Identifier: GPL-3.0-or-later
#include "obj.h"

#include <algorithm>
#include <cmath>

#include "faces.h"
#include "io_error.h"
#include "number_text.h"
#include "text_scanner.h"

namespace filmsticking::io {
namespace {

std::uint8_t to_byte(double share) {
  if (std::isnan(share)) return 0;
  return static_cast<std::uint8_t>(std::lround(std::clamp(share, 0.0, 1.0) * 255));
}

/// A face's corners, from zero. In the file they count from one, or backwards from the last vertex.
std::vector<std::int32_t> read_corners(TextScanner& line, std::size_t vertices) {
  std::vector<std::int32_t> corners;
  for (std::string_view word = line.word(); !word.empty(); word = line.word()) {
    long long index = 0;
    if (!parse_integer(word.substr(0, word.find('/')), index)) throw IoError("a face in it is not numbers");
    index += index < 0 ? static_cast<long long>(vertices) : -1;
    if (index < 0 || index > INT32_MAX) throw_no_vertex();
    corners.push_back(static_cast<std::int32_t>(index));
  }
  return corners;
}

}  // namespace

Model decode_obj(std::string_view bytes) {
  Model model;
  TextScanner file(bytes);
  std::size_t number = 0;
  for (std::string_view text; file.line(text);) {
    ++number;
    TextScanner line(text);
    const std::string_view keyword = line.word();
    if (keyword == "v") {
      Point p{};
      for (double& x : p)
        if (!line.number(x)) throw IoError("line " + std::to_string(number) + " is not a vertex");
      model.positions.push_back(p);
      std::vector<double> more;
      for (double x; line.remaining() > 0 && line.number(x);) more.push_back(x);
      if (const std::size_t n = more.size(); n >= 3)  // a fourth number alone is a weight
        model.colours.push_back({to_byte(more[n - 3]), to_byte(more[n - 2]), to_byte(more[n - 1])});
    } else if (keyword == "f") {
      append_polygon(read_corners(line, model.positions.size()), model);
    }
  }
  if (model.colours.size() != model.positions.size()) model.colours.clear();
  check_corners(model);
  return model;
}

void encode_obj(const Model& model, ByteWriter& out) {
  for (std::size_t i = 0; i < model.positions.size(); ++i)
    out.add([&](std::string& text) {
      text += "v";
      for (const double x : model.positions[i]) {
        text += ' ';
        append_number(text, x);  // as double: readers may take the text for either precision
      }
      if (!model.colours.empty())
        for (const std::uint8_t channel : model.colours[i]) {
          text += ' ';
          append_number(text, static_cast<float>(channel) / 255);
        }
      text += '\n';
    });
  for (const Triangle& triangle : model.triangles)
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
