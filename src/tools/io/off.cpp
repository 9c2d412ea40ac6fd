// SPDX-License-Identifier: GPL-3.0-or-later
// By hand: CGAL 5.5 takes the numbers in the header for what is there, and drops colours of some orders.
#include <algorithm>
#include <cmath>
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

  pcl::PolygonMesh decode() {
    header();
    for (std::size_t i = 0; i < vertices_; ++i) vertex();
    for (std::size_t i = 0; i < faces_; ++i) face();
    check_corners(triangles_, positions_.size());
    return make_mesh(cloud(), triangles_);
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

  void vertex() {
    if (!next()) throw_short();
    positions_.push_back({number(0), number(1), number(2)});
    // Colours stand behind normals; many writers put them into files named OFF, too.
    const std::size_t begin = kind_.normals ? 6 : 3;
    const std::size_t rest = words_.size() - std::min(words_.size(), begin) - (kind_.texture ? 2 : 0);
    const bool here = (kind_.colours || !kind_.texture) && (rest == 3 || rest == 4);
    if (kind_.colours && !here) refuse("has no colour");
    if (!here) return;
    Point colour{};
    for (std::size_t k = 0; k < 3; ++k) colour[k] = number(begin + k);
    colours_.push_back(colour);
    fractions_ |= std::any_of(words_.begin() + static_cast<std::ptrdiff_t>(begin), words_.end(),
                              [](std::string_view word) { return word.find('.') != std::string_view::npos; });
  }

  void face() {
    if (!next()) throw_short();
    const std::size_t corners = count(0);
    if (corners >= words_.size()) refuse("has fewer corners than it says");
    corners_.clear();
    for (std::size_t k = 1; k <= corners; ++k) corners_.push_back(corner_index(number(k)));
    append_polygon(corners_, triangles_);
  }

  /// Colours are bytes, or from 0 to 1 with a point.
  pcl::PCLPointCloud2 cloud() const {
    if (colours_.size() != positions_.size()) return make_cloud(positions_);
    double most = 0;
    for (const Point& c : colours_)
      for (const double x : c) {
        if (!(x >= 0 && x <= 255)) throw IoError("a colour in it is not from 0 to 255");
        most = std::max(most, x);
      }
    const double scale = fractions_ && most <= 1 ? 255 : 1;
    std::vector<Colour> bytes;
    bytes.reserve(colours_.size());
    for (const Point& c : colours_) {
      Colour colour{};
      for (std::size_t k = 0; k < 3; ++k) colour[k] = static_cast<std::uint8_t>(std::lround(c[k] * scale));
      bytes.push_back(colour);
    }
    return make_cloud(positions_, bytes);
  }

  std::string buffer_;
  std::string_view bytes_;
  Lines lines_;
  std::vector<std::string_view> words_;
  Kind kind_;
  std::size_t vertices_ = 0, faces_ = 0;
  bool fractions_ = false;
  std::vector<Point> positions_, colours_;
  std::vector<std::int32_t> corners_;
  std::vector<Triangle> triangles_;
};

}  // namespace

pcl::PolygonMesh decode_off(std::string_view bytes) { return OffFile(bytes).decode(); }

}  // namespace filmsticking::io
