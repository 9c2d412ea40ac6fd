// SPDX-License-Identifier: GPL-3.0-or-later
#include "pcd.h"

#include <pcl/io/lzf.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "io_error.h"
#include "scalar.h"
#include "text_scanner.h"

namespace filmsticking::io {
namespace {

enum class Data { Ascii, Binary, Compressed };

struct Field {
  std::string name;
  long long size = 4;
  char kind = 'F';
  long long count = 1;
};

struct Header {
  std::vector<Field> fields;
  std::size_t points = 0;
  Data data = Data::Ascii;
  std::optional<Point> viewpoint;
};

[[noreturn]] void throw_short() { throw IoError("it ends before its PCD header says"); }

constexpr long long kMost = 1LL << 40;  // so that no product of two leaves 128 bits, nor of checked ones 64

long long parse_count(TextScanner& line, const char* what) {
  long long value = 0;
  if (!parse_integer(line.word(), value) || value < 0 || value > kMost)
    throw IoError(std::string("its PCD header has a bad ") + what);
  return value;
}

Data parse_data(std::string_view word) {
  if (word == "ascii") return Data::Ascii;
  if (word == "binary") return Data::Binary;
  if (word == "binary_compressed") return Data::Compressed;
  throw IoError("its PCD header has unknown data '" + std::string(word) + "'");
}

/// Leaves `file` at the first byte after the header.
Header parse_header(TextScanner& file) {
  Header header;
  long long width = -1, height = 1, points = -1;
  std::string_view text;
  while (file.line(text)) {
    TextScanner line(text);
    const std::string_view keyword = line.word();
    if (keyword == "FIELDS" || keyword == "COLUMNS") {
      for (std::string_view name = line.word(); !name.empty(); name = line.word()) {
        header.fields.emplace_back();
        header.fields.back().name = name;
      }
    } else if (keyword == "SIZE") {
      for (Field& field : header.fields) field.size = parse_count(line, "SIZE");
    } else if (keyword == "TYPE") {
      for (Field& field : header.fields) {
        const std::string_view kind = line.word();
        if (kind != "F" && kind != "I" && kind != "U") throw IoError("its PCD header has a bad TYPE");
        field.kind = kind[0];
      }
    } else if (keyword == "COUNT") {
      for (Field& field : header.fields) field.count = parse_count(line, "COUNT");
    } else if (keyword == "WIDTH") {
      width = parse_count(line, "WIDTH");
    } else if (keyword == "HEIGHT") {
      height = parse_count(line, "HEIGHT");
    } else if (keyword == "VIEWPOINT") {
      Point place{};
      bool known = true;
      for (double& x : place) {
        TextScanner number(line.word());
        known = known && number.number(x) && std::isfinite(x);
      }
      if (known) header.viewpoint = place;  // it is only a hint
    } else if (keyword == "POINTS") {
      points = parse_count(line, "POINTS");
    } else if (keyword == "DATA") {
      header.data = parse_data(line.word());
      if (points < 0) {
        if (width < 0 || (height > 0 && width > kMost / height))
          throw IoError("its PCD header has no POINTS");
        points = width * height;
      }
      header.points = static_cast<std::size_t>(points);
      return header;
    }
  }
  throw IoError("it is not a PCD file");
}

Scalar scalar_of(const Field& field) {
  const bool is_signed = field.kind == 'I';
  if (field.kind == 'F' && field.size == 4) return Scalar::Float;
  if (field.kind == 'F' && field.size == 8) return Scalar::Double;
  if (field.kind != 'F' && field.size == 1) return is_signed ? Scalar::Int8 : Scalar::UInt8;
  if (field.kind != 'F' && field.size == 2) return is_signed ? Scalar::Int16 : Scalar::UInt16;
  if (field.kind != 'F' && field.size == 4) return is_signed ? Scalar::Int32 : Scalar::UInt32;
  if (field.kind != 'F' && field.size == 8) return is_signed ? Scalar::Int64 : Scalar::UInt64;
  throw IoError("its field '" + field.name + "' has an unknown type");
}

/// The fields that are read: x, y, z and the colour, if there is one.
struct Wanted {
  std::size_t axes[3] = {};
  std::size_t colour = 0;
  bool coloured = false;
};

Wanted find_wanted(const Header& header) {
  Wanted wanted;
  const auto find = [&header](const char* name, std::size_t& index) {
    for (index = 0; index < header.fields.size(); ++index)
      if (header.fields[index].name == name && header.fields[index].count > 0) return true;
    return false;
  };
  const char* const names[] = {"x", "y", "z"};
  for (int k = 0; k < 3; ++k)
    if (!find(names[k], wanted.axes[k])) throw IoError("its points have no x, y and z");
  for (const std::size_t axis : wanted.axes) scalar_of(header.fields[axis]);
  wanted.coloured =
      (find("rgb", wanted.colour) || find("rgba", wanted.colour)) && header.fields[wanted.colour].size == 4;
  return wanted;
}

/// The four bytes of a colour, whatever the field says about their type.
Colour unpack(std::uint32_t rgb) {
  const auto channel = [rgb](int shift) { return static_cast<std::uint8_t>(rgb >> shift & 255); };
  return {channel(16), channel(8), channel(0)};
}

Model read_text(const Header& header, const Wanted& wanted, std::string_view body) {
  std::size_t words = 0;
  for (const Field& field : header.fields) {
    if (static_cast<std::size_t>(field.count) > body.size()) throw_short();
    words += static_cast<std::size_t>(field.count);
  }
  if (header.points > body.size() / words) throw_short();

  Model model;
  model.positions.reserve(header.points);
  TextScanner text(body);
  for (std::size_t i = 0; i < header.points; ++i) {
    Point position{};
    Colour colour{};
    for (std::size_t f = 0; f < header.fields.size(); ++f) {
      const Field& field = header.fields[f];
      for (long long k = 0; k < field.count; ++k) {
        const std::string_view word = text.word();
        if (word.empty()) throw_short();
        const auto axis = std::find(wanted.axes, wanted.axes + 3, f) - wanted.axes;
        const bool is_colour = wanted.coloured && f == wanted.colour;
        if (k > 0 || (axis == 3 && !is_colour)) continue;
        TextScanner number(word);
        float single = 0;
        double value = 0;
        if (!(field.kind == 'F' && field.size == 4 ? number.number(single) : number.number(value)))
          throw IoError("its body has a word that is not a number");
        if (field.kind == 'F' && field.size == 4) value = static_cast<double>(single);
        if (axis < 3) position[static_cast<std::size_t>(axis)] = value;
        if (is_colour && field.kind == 'F')
          colour = unpack(load<std::uint32_t>(reinterpret_cast<char*>(&single)));
        if (is_colour && field.kind != 'F' && std::abs(value) < 1e10)
          colour = unpack(static_cast<std::uint32_t>(static_cast<long long>(value)));
      }
    }
    model.positions.push_back(position);
    if (wanted.coloured) model.colours.push_back(colour);
  }
  return model;
}

/// `by_field`: all points' first fields, then all second ones, and so on; else point after point.
Model read_binary(const Header& header, const Wanted& wanted, std::string_view body, bool by_field) {
  std::vector<std::size_t> offsets;  // of the fields in a point
  std::size_t step = 0;
  for (const Field& field : header.fields) {
    offsets.push_back(step);
    if (field.size > 8 || static_cast<std::size_t>(field.count) > body.size()) throw_short();
    step += static_cast<std::size_t>(field.size * field.count);
  }
  if (header.points > body.size() / std::max<std::size_t>(step, 1)) throw_short();

  const auto place = [&](std::size_t point, std::size_t f) {
    const auto width = static_cast<std::size_t>(header.fields[f].size * header.fields[f].count);
    return body.data() + (by_field ? offsets[f] * header.points + point * width : point * step + offsets[f]);
  };
  Model model;
  model.positions.reserve(header.points);
  for (std::size_t i = 0; i < header.points; ++i) {
    Point position{};
    for (std::size_t k = 0; k < 3; ++k)
      position[k] = load(place(i, wanted.axes[k]), scalar_of(header.fields[wanted.axes[k]]));
    model.positions.push_back(position);
    if (wanted.coloured) model.colours.push_back(unpack(load<std::uint32_t>(place(i, wanted.colour))));
  }
  return model;
}

std::string decompress(std::string_view body) {
  if (body.size() < 8) throw_short();
  const std::size_t compressed = load<std::uint32_t>(body.data()),
                    size = load<std::uint32_t>(body.data() + 4);
  // Three bytes stand for at most 264.
  if (compressed > body.size() - 8 || size / 100 > compressed) throw_short();
  std::string bytes(size, '\0');
  if (size > 0 && pcl::lzfDecompress(body.data() + 8, static_cast<unsigned>(compressed), bytes.data(),
                                     static_cast<unsigned>(size)) != size)
    throw IoError("its compressed data are broken");
  return bytes;
}

}  // namespace

Model decode_pcd(std::string_view bytes, const std::function<void()>& release) {
  TextScanner file(bytes);
  const Header header = parse_header(file);
  const Wanted wanted = find_wanted(header);
  const std::string_view body = bytes.substr(bytes.size() - file.remaining());
  Model model;
  if (header.data == Data::Ascii) {
    model = read_text(header, wanted, body);
  } else if (header.data == Data::Binary) {
    model = read_binary(header, wanted, body, false);
  } else {
    const std::string fields = decompress(body);
    if (release) release();
    model = read_binary(header, wanted, fields, true);
  }
  model.viewpoint = header.viewpoint;
  return model;
}

}  // namespace filmsticking::io
