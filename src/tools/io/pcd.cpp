// SPDX-License-Identifier: GPL-3.0-or-later
// By hand: PCL's reader of headers crashes on broken ones, and takes words that are no numbers for 0.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string>

#include "codecs.h"
#include "io_error.h"
#include "lzf.h"
#include "point_layout.h"
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
  long long width = -1, height = 1, points = -1;
  Data data = Data::Ascii;
  std::optional<Point> viewpoint;
  std::optional<std::array<double, 4>> orientation;
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
  if (word == "ascii" || word == "ASCII") return Data::Ascii;
  if (word == "binary") return Data::Binary;
  if (word == "binary_compressed") return Data::Compressed;
  throw IoError("its PCD header has unknown data '" + std::string(word) + "'");
}

/// So many finite numbers, or nothing: it is only a hint.
template <std::size_t kCount>
std::optional<std::array<double, kCount>> parse_hint(TextScanner& line) {
  std::array<double, kCount> numbers{};
  for (double& x : numbers)
    if (!parse_number(line.word(), x) || !std::isfinite(x)) return std::nullopt;
  return numbers;
}

/// A line of the header. An unknown keyword changes nothing.
void parse_line(std::string_view keyword, TextScanner& line, Header& header) {
  if (keyword == "FIELDS" || keyword == "COLUMNS") {
    for (std::string_view name = line.word(); !name.empty(); name = line.word())
      header.fields.push_back({std::string(name)});
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
    header.width = parse_count(line, "WIDTH");
  } else if (keyword == "HEIGHT") {
    header.height = parse_count(line, "HEIGHT");
  } else if (keyword == "VIEWPOINT") {
    header.viewpoint = parse_hint<3>(line);
    if (header.viewpoint) header.orientation = parse_hint<4>(line);
  } else if (keyword == "POINTS") {
    header.points = parse_count(line, "POINTS");
  } else if (keyword == "DATA") {
    header.data = parse_data(line.word());
  }
}

/// Leaves `file` at the first byte after the header.
Header parse_header(TextScanner& file) {
  Header header;
  std::string_view text, keyword;
  while (keyword != "DATA") {
    if (!file.line(text)) throw IoError("it is not a PCD file");
    TextScanner line(text, TextScanner::kBlanks);
    keyword = line.word();
    parse_line(keyword, line, header);
  }
  const bool product = header.width >= 0 && (header.height == 0 || header.width <= kMost / header.height);
  if (header.points < 0 && !product) throw IoError("its PCD header has no POINTS");
  if (header.points < 0) header.points = header.width * header.height;
  if (!product || header.points != header.width * header.height)
    header.width = header.points, header.height = 1;
  return header;
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

std::vector<Column> columns_of(const Header& header) {
  std::vector<Column> columns;
  for (const Field& field : header.fields)
    if (field.count > 0)
      columns.push_back(
          {field.name == "_" ? "" : field.name, scalar_of(field), static_cast<std::size_t>(field.count)});
  if (columns.empty()) throw IoError("its points have no x, y and z");
  return columns;
}

/// Refuses more points than the body can hold. Returns the bytes of a point.
std::size_t check_size(const Header& header, const std::vector<Column>& columns, std::string_view body) {
  std::size_t step = 0, words = 0;
  for (const Column& column : columns) {
    if (column.count > body.size()) throw_short();
    step += size_of(column.type) * column.count;
    words += column.count;
  }
  const auto points = static_cast<std::size_t>(header.points);
  if (header.data != Data::Compressed && points > body.size() / (header.data == Data::Ascii ? words : step))
    throw_short();
  if (points > UINT32_MAX / step) throw IoError("its points take more than 4 GB");
  return step;
}

/// The packed bytes of a body. PCL leaves the padding "_" out, others do not; then its columns are removed.
std::string_view packed(const Header& header, std::vector<Column>& columns, std::string_view body) {
  if (body.size() < 8) throw_short();
  const std::size_t compressed = load<std::uint32_t>(body.data()),
                    size = load<std::uint32_t>(body.data() + 4);
  const auto points = static_cast<std::size_t>(header.points);
  std::size_t step = check_size(header, columns, body);
  if (size != points * step) {
    columns.erase(
        std::remove_if(columns.begin(), columns.end(), [](const Column& c) { return c.name.empty(); }),
        columns.end());
    step = columns.empty() ? 0 : check_size(header, columns, body);
  }
  // Three bytes stand for at most 264.
  if (step == 0 || compressed > body.size() - 8 || size != points * step || size / 100 > compressed)
    throw_short();
  return body.substr(8, compressed);
}

/// Copies values that lie side by side to every `step` bytes.
template <std::size_t kSize>
void spread(const char* from, std::size_t count, std::uint8_t* to, std::size_t step) {
  for (std::size_t i = 0; i < count; ++i, from += kSize, to += step) std::memcpy(to, from, kSize);
}

void spread(const char* from, std::size_t count, std::size_t size, std::uint8_t* to, std::size_t step) {
  if (size == 4) return spread<4>(from, count, to, step);
  if (size == 8) return spread<8>(from, count, to, step);
  for (std::size_t i = 0; i < count; ++i, from += size, to += step) std::memcpy(to, from, size);
}

/// The values of each field, one field after the other.
void read_compressed(std::string_view bytes, const std::vector<Column>& columns, const PointLayout& layout,
                     pcl::PCLPointCloud2& cloud) {
  LzfReader packed(bytes);
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const std::size_t size = size_of(columns[c].type) * columns[c].count;
    const std::size_t at_once = LzfReader::kMost / size;  // 0: a value is longer than a piece
    for (std::size_t i = 0; at_once > 0 && i < size_of(cloud); i += at_once) {
      const std::size_t count = std::min(at_once, size_of(cloud) - i);
      const char* const values = packed.take(count * size);
      if (layout.offset(c) != PointLayout::kNowhere)
        spread(values, count, size, &cloud.data[i * cloud.point_step + layout.offset(c)], cloud.point_step);
    }
    for (std::size_t i = 0; at_once == 0 && i < size_of(cloud); ++i)
      for (std::size_t k = 0; k < size; k += LzfReader::kMost) {
        const std::size_t part = std::min(LzfReader::kMost, size - k);
        const char* const values = packed.take(part);
        if (layout.offset(c) != PointLayout::kNowhere)
          std::memcpy(&cloud.data[i * cloud.point_step + layout.offset(c) + k], values, part);
      }
  }
  if (!packed.at_end()) throw IoError("its compressed data are broken");
}

/// Colours packed into a float are written as a float, or as the whole number of the same bits.
bool store_packed(std::string_view word, Scalar type, void* to) {
  constexpr long long kLeast = 1 << 16;
  long long value = 0;
  if (type != Scalar::Float || !parse_integer(word, value) || value < kLeast || value > UINT32_MAX)
    return false;
  const auto bits = static_cast<std::uint32_t>(value);
  std::memcpy(to, &bits, sizeof bits);
  return true;
}

void read_text(std::string_view file, std::string_view body, const std::vector<Column>& columns,
               const PointLayout& layout, pcl::PCLPointCloud2& cloud) {
  TextScanner text(body, TextScanner::kBlanks);
  char skipped[8];
  std::uint8_t* point = cloud.data.data();
  for (std::size_t i = 0; i < size_of(cloud); ++i, point += cloud.point_step)
    for (std::size_t c = 0; c < columns.size(); ++c)
      for (std::size_t k = 0; k < columns[c].count; ++k) {
        const Scalar type = columns[c].type;
        void* const to = layout.offset(c) == PointLayout::kNowhere
                             ? static_cast<void*>(skipped)
                             : static_cast<void*>(point + layout.offset(c) + k * size_of(type));
        const std::string_view word = text.word();
        if (word.empty()) throw_short();
        if (columns[c].name == "rgb" && store_packed(word, type, to)) continue;
        if (!store_number(word, type, to)) throw_no_number(file, word);
      }
  if (!text.word().empty()) throw IoError("it has more numbers than its PCD header says; correct the header");
}

}  // namespace

Cloud decode_pcd(std::string_view bytes) {
  TextScanner file(bytes);
  const Header header = parse_header(file);
  const std::string_view body = bytes.substr(bytes.size() - file.remaining());
  std::vector<Column> columns = columns_of(header);
  const std::size_t step = check_size(header, columns, body);
  std::string_view values = body;
  if (header.data == Data::Compressed) values = packed(header, columns, body);
  const PointLayout layout(columns);
  const auto points = static_cast<std::size_t>(header.points);
  Cloud cloud;
  if (header.data == Data::Binary) {
    cloud.points = layout.read(body, points, false, cloud.notes);
    note_more(body.size(), points, step, cloud.notes);
  } else {
    cloud.points = layout.cloud(points);
    header.data == Data::Ascii ? read_text(bytes, body, columns, layout, cloud.points)
                               : read_compressed(values, columns, layout, cloud.points);
    layout.finish(cloud.points, cloud.notes);
  }
  cloud.points.width = static_cast<std::uint32_t>(header.width);
  cloud.points.height = static_cast<std::uint32_t>(header.height);
  cloud.points.row_step = cloud.points.width * cloud.points.point_step;
  cloud.viewpoint = header.viewpoint;
  cloud.orientation = header.orientation;
  return cloud;
}

void encode_pcd(const Cloud& cloud, ByteWriter& out) {
  const pcl::PCLPointCloud2& points = cloud.points;
  const PositionFields checked(points);
  std::string names, sizes, kinds, counts;
  for (const pcl::PCLPointField& field : points.fields) {
    const auto type = static_cast<Scalar>(field.datatype);
    const bool real = type == Scalar::Float || type == Scalar::Double;
    const bool is_signed =
        type == Scalar::Int8 || type == Scalar::Int16 || type == Scalar::Int32 || type == Scalar::Int64;
    names += ' ' + field.name;
    sizes += ' ' + std::to_string(size_of(type));
    kinds += real ? " F" : is_signed ? " I" : " U";
    counts += ' ' + std::to_string(std::max(1U, field.count));
  }
  std::string viewpoint;
  for (const double x : cloud.viewpoint.value_or(Point{})) append_number(viewpoint, x), viewpoint += ' ';
  for (const double x : cloud.orientation.value_or(std::array<double, 4>{1, 0, 0, 0}))
    append_number(viewpoint, x), viewpoint += ' ';
  viewpoint.pop_back();
  out.append("# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS" + names + "\nSIZE" + sizes +
             "\nTYPE" + kinds + "\nCOUNT" + counts + "\nWIDTH " + std::to_string(points.width) + "\nHEIGHT " +
             std::to_string(points.height) + "\nVIEWPOINT " + viewpoint + "\nPOINTS " +
             std::to_string(size_of(points)) + "\nDATA binary\n");
  for (std::size_t i = 0; i < size_of(points); ++i)
    out.add([&](std::string& bytes) {
      for (const pcl::PCLPointField& field : points.fields)
        bytes.append(reinterpret_cast<const char*>(bytes_of(points, i)) + field.offset,
                     size_of(Scalar{field.datatype}) * std::max(1U, field.count));
    });
}

}  // namespace filmsticking::io
