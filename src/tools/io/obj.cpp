// SPDX-License-Identifier: GPL-3.0-or-later
// By hand: CGAL 5.5 reads no colours, refuses files without faces, and takes an index one past the end.
// Two passes, the first for what the lines have, so that points are in memory once.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "codecs.h"
#include "io_error.h"
#include "text_scanner.h"
#include "text_table.h"

namespace filmsticking::io {
namespace {

class ObjFile {
 public:
  explicit ObjFile(std::string_view bytes) : text_(plain_text(bytes, buffer_)) {}

  Shape decode() {
    survey();
    const PointLayout layout(columns());
    shape_.points = layout.cloud(vertices_);
    read(layout);
    check_corners(shape_.triangles, vertices_);
    layout.finish(shape_.points, shape_.notes);
    if (normals_ > 0 && !normals_kept_) leave_out_normals();
    if (texture_) shape_.notes.push_back("left out its texture coordinates");
    return std::move(shape_);
  }

 private:
  [[noreturn]] static void refuse(std::size_t line, const std::string& what) {
    throw IoError("line " + std::to_string(line) + " " + what);
  }

  /// Calls use(keyword, rest of the line, its number).
  template <class Use>
  void each_line(const Use& use) {
    Lines lines(text_);
    for (std::string_view text; lines.next(text);) {
      TextScanner line(text.substr(0, text.find('#')), TextScanner::kBlanks);
      const std::string_view keyword = line.word();
      if (!keyword.empty()) use(keyword, line, lines.number());
    }
  }

  void survey() {
    each_line([&](std::string_view keyword, TextScanner& line, std::size_t) {
      if (keyword == "v") {
        std::string_view fourth;
        std::size_t numbers = 0;
        for (std::string_view word = line.word(); !word.empty(); word = line.word(), ++numbers)
          if (numbers == 3) fourth = word;
        fewest_ = vertices_ == 0 ? numbers : std::min(fewest_, numbers);
        most_ = std::max(most_, numbers);
        double weight = 0;
        weights_ = weights_ && numbers == 7 && parse_number(fourth, weight) && weight == 1;
        ++vertices_;
      } else if (keyword == "vn") {
        ++normals_;
      } else {
        texture_ |= keyword == "vt";
      }
    });
    coloured_ = fewest_ >= 6;
    if (!coloured_ && most_ >= 6) shape_.notes.push_back("left out its colours, which not all points have");
    normals_kept_ = normals_ > 0 && normals_ == vertices_;
  }

  std::vector<Column> columns() const {
    std::vector<Column> columns;
    for (const char* name : {"x", "y", "z"}) columns.push_back({name, Scalar::Double});
    for (const char* name : {"nx", "ny", "nz"})
      if (normals_kept_) columns.push_back({name, Scalar::Float});
    for (const char* name : {"r", "g", "b"})
      if (coloured_) columns.push_back({name, Scalar::Float});
    return columns;
  }

  void read(const PointLayout& layout) {
    std::uint8_t *point = shape_.points.data.data(), *normal = point;
    const std::size_t colours = normals_kept_ ? 6 : 3;
    std::size_t seen = 0;
    each_line([&](std::string_view keyword, TextScanner& line, std::size_t number) {
      if (keyword == "v") {
        for (std::size_t k = 0; k < 3; ++k) put<double>(line, point + layout.offset(k), number, "vertex");
        if (coloured_) {
          if (weights_) line.word();
          for (std::size_t k = colours; k < colours + 3; ++k)
            put<float>(line, point + layout.offset(k), number, "vertex with a colour");
        }
        point += layout.step(), ++seen;
      } else if (keyword == "vn" && normals_kept_) {
        for (std::size_t k = 3; k < 6; ++k) put<float>(line, normal + layout.offset(k), number, "normal");
        normal += layout.step();
      } else if (keyword == "f") {
        face(line, seen, number);
      }
    });
  }

  template <typename T>
  static void put(TextScanner& line, std::uint8_t* to, std::size_t number, const char* what) {
    T value = 0;
    if (!line.number(value)) refuse(number, std::string("is not a ") + what);
    std::memcpy(to, &value, sizeof value);
  }

  /// A corner's index from zero. In the file they count from one, or backwards from the last one so far.
  static std::int64_t index_of(std::string_view word, std::size_t so_far, std::size_t line) {
    long long index = 0;
    if (!parse_integer(word, index)) refuse(line, "is a face of what are no numbers");
    return index + (index < 0 ? static_cast<std::int64_t>(so_far) : -1);
  }

  /// A corner is "vertex", "vertex/texture" or "vertex/texture/normal", where texture may be empty.
  void face(TextScanner& line, std::size_t seen, std::size_t number) {
    corners_.clear();
    for (std::string_view word = line.word(); !word.empty(); word = line.word()) {
      const std::size_t first = word.find('/');
      const std::int64_t corner = index_of(word.substr(0, first), seen, number);
      corners_.push_back(corner_index(static_cast<double>(corner)));
      const std::size_t second = first == std::string_view::npos ? first : word.find('/', first + 1);
      if (normals_kept_ && second != std::string_view::npos)
        normals_kept_ = index_of(word.substr(second + 1), normals_, number) == corner;
    }
    append_polygon(corners_, shape_.triangles);
  }

  /// Normals of corners, not of points.
  void leave_out_normals() {
    auto& fields = shape_.points.fields;
    fields.erase(std::remove_if(fields.begin(), fields.end(),
                                [](const auto& field) { return field.name.substr(0, 7) == "normal_"; }),
                 fields.end());
    shape_.notes.push_back("left out its normals, which are of corners of faces");
  }

  std::string buffer_;
  std::string_view text_;
  Shape shape_;
  std::size_t vertices_ = 0, normals_ = 0, fewest_ = 0, most_ = 0;  // numbers of vertices, normals; words
  bool weights_ = true;  // is the fourth of seven numbers 1 everywhere? Else the seventh is alpha
  bool coloured_ = false, normals_kept_ = false, texture_ = false;
  std::vector<std::int32_t> corners_;
};

}  // namespace

Shape decode_obj(std::string_view bytes) { return ObjFile(bytes).decode(); }

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
