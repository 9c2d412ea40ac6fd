// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "codecs.h"
#include "io_error.h"
#include "text_scanner.h"
#include "text_table.h"

namespace filmsticking::io {
namespace {

using Matrix = std::array<double, 16>;

/// The lines of a header: columns, rows, the scanner's place, its axes, the matrix.
constexpr std::size_t kHeaderWords[] = {1, 1, 3, 3, 3, 3, 4, 4, 4, 4};

struct Scan {
  std::size_t columns = 0, rows = 0;
  Matrix pose{};
  std::vector<Point> points;  // in the scanner's coordinates; not finite without a return
  std::vector<Colour> colours;
};

class PtxFile {
 public:
  explicit PtxFile(std::string_view bytes) : text_(plain_text(bytes, buffer_)), lines_(text_) {}

  /// The next station; false at the end.
  bool next(Scan& scan) {
    scan = {};
    if (!line()) return false;
    scan.columns = count();
    require_line("rows");
    scan.rows = count();
    if (scan.columns > text_.size() || scan.rows > text_.size() / std::max<std::size_t>(scan.columns, 1))
      throw_short();
    for (int k = 0; k < 4; ++k) {
      require_line("the scanner's place and axes");
      numbers(3);
    }
    for (std::size_t row = 0; row < 4; ++row) {
      require_line("the matrix");
      numbers(4);
      for (std::size_t k = 0; k < 4; ++k) scan.pose[4 * row + k] = values_[k];
    }
    turn(scan.pose);
    points(scan);
    return true;
  }

  std::size_t without_return() const { return without_return_; }

 private:
  bool line() {
    std::string_view text;
    while (lines_.next(text)) {
      TextScanner scanner(text, TextScanner::kBlanks);
      words_.clear();
      for (std::string_view word = scanner.word(); !word.empty(); word = scanner.word())
        words_.push_back(word);
      if (!words_.empty()) return true;
    }
    return false;
  }

  [[noreturn]] static void throw_short() { throw IoError("it ends before its PTX header says"); }
  [[noreturn]] void refuse(const std::string& what) const {
    throw IoError("line " + std::to_string(lines_.number()) + " " + what);
  }

  void require_line(const char*) {
    if (!line()) throw_short();
  }

  std::size_t count() const {
    long long value = 0;
    if (words_.size() != 1 || !parse_integer(words_[0], value) || value < 0)
      refuse("is not a number of columns or rows, as a PTX header begins with");
    return static_cast<std::size_t>(value);
  }

  void numbers(std::size_t wanted) {
    if (words_.size() != wanted)
      refuse("has " + std::to_string(words_.size()) + " numbers where a PTX header has " +
             std::to_string(wanted));
    values_.clear();
    for (const std::string_view word : words_) {
      double value = 0;
      if (!parse_number(word, value)) throw_no_number(text_, word);
      values_.push_back(value);
    }
  }

  /// The matrix stands for rows, with the place in the last one; some writers have it for columns.
  static void turn(Matrix& m) {
    const bool by_rows = m[3] == 0 && m[7] == 0 && m[11] == 0;
    if (by_rows)
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = i + 1; k < 4; ++k) std::swap(m[4 * i + k], m[4 * k + i]);
  }

  void points(Scan& scan) {
    constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
    const std::size_t all = scan.columns * scan.rows;
    bool coloured = true;
    for (std::size_t i = 0; i < all; ++i) {
      if (!line()) throw_short();
      if (words_.size() != 4 && words_.size() != 7 && words_.size() != 3)
        refuse("has " + std::to_string(words_.size()) + " numbers; a point of PTX has 4, or 7 with a colour");
      numbers(words_.size());
      Point p{values_[0], values_[1], values_[2]};
      const bool none = p == Point{};
      without_return_ += none ? 1 : 0;
      scan.points.push_back(none ? Point{kNotANumber, kNotANumber, kNotANumber} : p);
      coloured = coloured && values_.size() == 7;
      if (coloured) scan.colours.push_back(colour());
    }
    if (!coloured) scan.colours.clear();
  }

  Colour colour() const {
    Colour colour{};
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = values_[4 + k];
      if (!(x >= 0 && x <= 255)) refuse("has a colour that is not from 0 to 255");
      colour[k] = static_cast<std::uint8_t>(x);
    }
    return colour;
  }

  std::string buffer_;
  std::string_view text_;
  Lines lines_;
  std::vector<std::string_view> words_;
  std::vector<double> values_;
  std::size_t without_return_ = 0;
};

Point moved(const Point& p, const Matrix& m) {
  Point to{};
  for (std::size_t k = 0; k < 3; ++k)
    to[k] = m[4 * k] * p[0] + m[4 * k + 1] * p[1] + m[4 * k + 2] * p[2] + m[4 * k + 3];
  return to;
}

Point place_of(const Matrix& m) { return {m[3], m[7], m[11]}; }

}  // namespace

bool is_ptx(std::string_view bytes) {
  Lines lines(bytes);
  for (const std::size_t wanted : kHeaderWords) {
    std::string_view line;
    do
      if (!lines.next(line)) return false;
    while (line.find_first_not_of(TextScanner::kBlanks) == std::string_view::npos);
    TextScanner scanner(line, TextScanner::kBlanks);
    for (std::size_t k = 0; k < wanted; ++k)
      if (double value = 0; !parse_number(scanner.word(), value)) return false;
    if (!scanner.word().empty()) return false;
  }
  return true;
}

Cloud decode_ptx(std::string_view bytes) {
  PtxFile file(bytes);
  std::vector<Point> points, stations;
  std::vector<Colour> colours;
  bool coloured = true;
  std::size_t count = 0;
  for (Scan scan; file.next(scan); ++count) {
    for (Point& p : scan.points) points.push_back(moved(p, scan.pose));
    stations.resize(points.size(), place_of(scan.pose));
    coloured = coloured && scan.colours.size() == scan.points.size();
    if (coloured) colours.insert(colours.end(), scan.colours.begin(), scan.colours.end());
  }
  if (count == 0) throw IoError("it is not a PTX file");
  if (!coloured) colours.clear();
  Cloud cloud;
  cloud.points = with_stations(make_cloud(points, colours), stations);
  if (count == 1 && !stations.empty()) cloud.viewpoint = stations[0];
  cloud.notes.push_back("left out the intensities" +
                        (file.without_return() > 0
                             ? " and " + std::to_string(file.without_return()) + " points without a return"
                             : std::string()));
  return cloud;
}

std::vector<Station> decode_stations(std::string_view bytes) {
  PtxFile file(bytes);
  std::vector<Station> stations;
  for (Scan scan; file.next(scan);) stations.push_back({make_cloud(scan.points, scan.colours), scan.pose});
  if (stations.empty()) throw IoError("it is not a PTX file");
  return stations;
}

}  // namespace filmsticking::io
