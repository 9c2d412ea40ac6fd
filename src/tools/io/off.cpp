// SPDX-License-Identifier: GPL-3.0-or-later
// By hand: CGAL 5.5 takes the numbers in the header for what is there, and drops colours of some orders.
#include <algorithm>
#include <cstring>
#include <string>

#include "codecs.h"
#include "io_error.h"
#include "text_scanner.h"
#include "text_table.h"

namespace filmsticking::io {
namespace {

/// What stands behind the coordinates of each vertex.
struct Kind {
  bool colours = false, normals = false, texture = false;
};

class OffFile {
 public:
  explicit OffFile(std::string_view bytes) : bytes_(plain_text(bytes, buffer_)), lines_(bytes_) {}

  Shape decode() {
    header();
    if (vertices_ > 0 && !next()) throw_short();
    const PointLayout layout(columns());
    shape_.points = layout.cloud(vertices_);
    vertices(layout);
    for (std::size_t i = 0; i < faces_; ++i) face();
    check_corners(shape_.triangles, vertices_);
    layout.finish(shape_.points, shape_.notes);
    if (kind_.texture) shape_.notes.push_back("left out its texture coordinates");
    if (left_out_) shape_.notes.push_back("left out the other numbers of its vertices");
    if (coloured_faces_) shape_.notes.push_back("left out the colours of its faces");
    return std::move(shape_);
  }

 private:
  /// The words of the next line that is no comment.
  bool next() {
    std::string_view line;
    while (lines_.next(line)) {
      line = line.substr(0, line.find('#'));
      TextScanner scanner(line, TextScanner::kBlanks);
      words_.clear();
      for (std::string_view word = scanner.word(); !word.empty(); word = scanner.word())
        words_.push_back(word);
      if (!words_.empty()) return true;
    }
    return false;
  }

  [[noreturn]] void refuse(const std::string& what) const {
    throw IoError("line " + std::to_string(lines_.number()) + " " + what);
  }

  void header() {
    if (!next()) throw IoError("it is not an OFF file");
    std::string_view word = words_[0];
    const bool named = word.size() >= 3 && word.substr(word.size() - 3) == "OFF";
    if (!named) throw IoError("it is not an OFF file");
    word.remove_suffix(3);
    for (const std::string_view part : {"ST", "C", "N"})
      if (word.substr(0, part.size()) == part) {
        (part == "ST" ? kind_.texture : part == "C" ? kind_.colours : kind_.normals) = true;
        word.remove_prefix(part.size());
      }
    if (!word.empty())
      refuse("says that its points have four coordinates, or other dimensions; save it as OFF");
    words_.erase(words_.begin());
    if (!words_.empty() && words_[0] == "BINARY") refuse("says BINARY; save it as a text");
    if (words_.empty() && !next()) throw_short();
    vertices_ = count(0);
    faces_ = words_.size() > 1 ? count(1) : 0;
    if (vertices_ > bytes_.size() || faces_ > bytes_.size()) throw_short();
  }

  std::size_t count(std::size_t k) const {
    long long value = 0;
    if (!parse_integer(words_[k], value) || value < 0)
      refuse("does not have the numbers of vertices and faces");
    return static_cast<std::size_t>(value);
  }

  [[noreturn]] static void throw_short() { throw IoError("it ends before its OFF header says"); }

  double number(std::size_t k) const {
    double value = 0;
    if (k >= words_.size()) refuse("is no vertex: it has " + std::to_string(words_.size()) + " numbers");
    if (!parse_number(words_[k], value)) throw_no_number(bytes_, words_[k]);
    return value;
  }

  /// From the words of the first vertex. Colours stand behind normals, texture coordinates behind them; many
  /// writers put colours into files named OFF, too.
  std::vector<Column> columns() {
    std::vector<Column> columns;
    for (const char* name : {"x", "y", "z"}) columns.push_back({name, Scalar::Double});
    for (const char* name : {"nx", "ny", "nz"})
      if (kind_.normals) columns.push_back({name, Scalar::Float});
    const std::size_t known = columns.size() + (kind_.texture ? 2 : 0);
    numbers_ = vertices_ > 0 ? words_.size() : known;
    if (numbers_ < known) refuse("is no vertex: it has " + std::to_string(numbers_) + " numbers");
    const std::size_t more = numbers_ - known;
    const bool coloured = (kind_.colours || !kind_.texture) && (more == 3 || more == 4);
    if (kind_.colours && !coloured && vertices_ > 0) refuse("has no colour");
    for (const char* name : {"r", "g", "b"})
      if (coloured) columns.push_back({name, Scalar::Float});
    left_out_ = more > 0 && !coloured;
    columns_ = columns.size();
    return columns;
  }

  void vertices(const PointLayout& layout) {
    std::uint8_t* to = shape_.points.data.data();
    for (std::size_t i = 0; i < vertices_; ++i, to += layout.step()) {
      if (i > 0 && !next()) throw_short();
      if (words_.size() != numbers_)
        refuse("has " + std::to_string(words_.size()) + " numbers, and the first vertex has " +
               std::to_string(numbers_));
      for (std::size_t k = 0; k < columns_; ++k) {
        const double value = number(k);
        const float single = to_float(value);
        k < 3 ? std::memcpy(to + layout.offset(k), &value, sizeof value)
              : std::memcpy(to + layout.offset(k), &single, sizeof single);
      }
    }
  }

  void face() {
    if (!next()) throw_short();
    const std::size_t corners = count(0);
    if (corners >= words_.size()) refuse("has fewer corners than it says");
    coloured_faces_ |= words_.size() > corners + 1;
    corners_.clear();
    for (std::size_t k = 1; k <= corners; ++k) corners_.push_back(corner_index(number(k)));
    append_polygon(corners_, shape_.triangles);
  }

  std::string buffer_;
  std::string_view bytes_;
  Lines lines_;
  std::vector<std::string_view> words_;
  Kind kind_;
  std::size_t vertices_ = 0, faces_ = 0;
  std::size_t numbers_ = 0, columns_ = 0;  // of a vertex, and those that are kept
  bool left_out_ = false, coloured_faces_ = false;
  std::vector<std::int32_t> corners_;
  Shape shape_;
};

}  // namespace

Shape decode_off(std::string_view bytes) { return OffFile(bytes).decode(); }

}  // namespace filmsticking::io
