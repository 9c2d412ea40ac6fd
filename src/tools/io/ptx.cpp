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
  bool coloured = false;  // as far as its points are read

  std::size_t points() const { return columns * rows; }
};

/// A point in the scanner's coordinates; not finite without a return.
struct Return {
  Point place{};
  float intensity = 0;
  Colour colour{};
};

class PtxFile {
 public:
  explicit PtxFile(std::string_view bytes) : text_(plain_text(bytes, buffer_)), lines_(text_) {}

  /// The header of the next station; false at the end.
  bool header(Scan& scan) {
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
    return true;
  }

  /// Passes the lines of the points; whether all have a colour.
  void skip_points(Scan& scan) {
    scan.coloured = true;
    for (std::size_t i = 0; i < scan.points(); ++i) scan.coloured &= point_line() == 7;
  }

  /// Calls use(const Return&) for each point.
  template <class Use>
  void points(const Scan& scan, const Use& use) {
    constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 0; i < scan.points(); ++i) {
      numbers(point_line());
      Return point{{values_[0], values_[1], values_[2]}};
      if (point.place == Point{}) point.place = {kNotANumber, kNotANumber, kNotANumber}, ++without_return_;
      if (values_.size() > 3) point.intensity = to_float(values_[3]);
      if (scan.coloured) point.colour = colour();
      use(point);
    }
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

  /// Number of words of the next point.
  std::size_t point_line() {
    if (!line()) throw_short();
    if (words_.size() != 4 && words_.size() != 7 && words_.size() != 3)
      refuse("has " + std::to_string(words_.size()) + " numbers; a point of PTX has 4, or 7 with a colour");
    return words_.size();
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

/// The stations, so that memory for their points is taken once.
std::vector<Scan> survey(std::string_view bytes) {
  PtxFile file(bytes);
  std::vector<Scan> scans;
  for (Scan scan; file.header(scan); scans.push_back(scan)) file.skip_points(scan);
  if (scans.empty()) throw IoError("it is not a PTX file");
  return scans;
}

/// Where a point's values go.
class PointWriter {
 public:
  PointWriter(bool coloured, bool stations, std::size_t points)
      : layout_(columns(coloured, stations)), cloud_(layout_.cloud(points)), to_(cloud_.data.data()) {}

  void add(const Return& point, const Point* station) {
    std::size_t column = 0;
    for (const double x : point.place) put(x, column++);
    put(point.intensity, column++);
    if (station)
      for (const double x : *station) put(x, column++);
    for (std::size_t k = 0; column < columns_; ++k) put(point.colour[k], column++);
    to_ += layout_.step();
  }

  pcl::PCLPointCloud2 take(Notes& notes) {
    layout_.finish(cloud_, notes);
    return std::move(cloud_);
  }

 private:
  std::vector<Column> columns(bool coloured, bool stations) {
    std::vector<Column> columns;
    for (const char* name : {"x", "y", "z"}) columns.push_back({name, Scalar::Double});
    columns.push_back({"intensity", Scalar::Float});
    for (const char* name : kStationFields)
      if (stations) columns.push_back({name, Scalar::Double});
    for (const char* name : {"r", "g", "b"})
      if (coloured) columns.push_back({name, Scalar::UInt8});
    columns_ = columns.size();
    return columns;
  }

  template <typename T>
  void put(T value, std::size_t column) {
    std::memcpy(to_ + layout_.offset(column), &value, sizeof value);
  }

  std::size_t columns_ = 0;
  PointLayout layout_;
  pcl::PCLPointCloud2 cloud_;
  std::uint8_t* to_;
};

bool all_coloured(const std::vector<Scan>& scans) {
  return std::all_of(scans.begin(), scans.end(), [](const Scan& scan) { return scan.coloured; });
}

bool some_coloured(const std::vector<Scan>& scans) {
  return std::any_of(scans.begin(), scans.end(),
                     [](const Scan& scan) { return scan.coloured && scan.points() > 0; });
}

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
  std::vector<Scan> scans = survey(bytes);
  const bool coloured = all_coloured(scans), lost = !coloured && some_coloured(scans);
  std::size_t count = 0;
  for (const Scan& scan : scans) count += scan.points();
  PtxFile file(bytes);
  PointWriter writer(coloured, true, count);
  for (Scan& scan : scans) {
    file.header(scan);
    scan.coloured = coloured;
    const Point station = place_of(scan.pose);
    file.points(scan, [&](Return point) {
      point.place = moved(point.place, scan.pose);
      writer.add(point, &station);
    });
  }
  Cloud cloud;
  cloud.points = writer.take(cloud.notes);
  if (scans.size() == 1 && count > 0) cloud.viewpoint = place_of(scans[0].pose);
  if (lost) cloud.notes.push_back("left out its colours, which not all points have");
  if (file.without_return() > 0)
    cloud.notes.push_back("left out " + std::to_string(file.without_return()) + " points without a return");
  return cloud;
}

std::vector<Station> decode_stations(std::string_view bytes) {
  PtxFile file(bytes);
  std::vector<Station> stations;
  Notes notes;
  for (Scan scan : survey(bytes)) {
    const bool coloured = scan.coloured;
    file.header(scan);
    scan.coloured = coloured;
    PointWriter writer(coloured, false, scan.points());
    file.points(scan, [&](const Return& point) { writer.add(point, nullptr); });
    stations.push_back({writer.take(notes), scan.pose});
  }
  return stations;
}

}  // namespace filmsticking::io
