// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of points as text: two passes, the first for what the columns are, the second for the points.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "codecs.h"
#include "field_role.h"
#include "io_error.h"
#include "text_columns.h"
#include "text_scanner.h"
#include "text_table.h"

namespace filmsticking::io {
namespace {

constexpr std::size_t kMostColumns = 1000;

[[noreturn]] void refuse(std::size_t line, const std::string& what) {
  throw IoError("line " + std::to_string(line) + " " + what);
}

std::string numbered(std::size_t count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string shown(std::string_view word) {
  constexpr std::size_t kShown = 30;
  std::string text(word.substr(0, kShown));
  for (char& c : text)
    if (c < ' ' || c > '~') c = '?';
  return "'" + text + (word.size() > kShown ? ".." : "") + "'";
}

/// The names in a line that may be a header; a name with "[]" begins a list of any length.
struct ColumnNames {
  std::vector<std::string> names;
  bool list = false;
  bool x = false, y = false, z = false;

  bool complete() const { return x && y && z; }
};

ColumnNames names_of(std::string_view line, const TextStyle& style) {
  char separator = style.separator;
  for (const char c : {',', ';', '\t'})
    if (separator == 0 && line.find(c) != std::string_view::npos) separator = c;
  std::vector<std::string_view> words;
  const auto take = [&](std::string_view word) {
    if (words.size() < kMostColumns) words.push_back(word);
  };
  if (separator != 0) {
    for (std::size_t begin = 0; begin <= line.size();) {
      const std::size_t end = std::min(line.find(separator, begin), line.size());
      take(line.substr(begin, end - begin));
      begin = end + 1;
    }
  } else {
    TextScanner scanner(line, TextScanner::kBlanks);
    for (std::string_view word = scanner.word(); !word.empty(); word = scanner.word())
      if (word[0] != '[' && word[0] != '(' && word != "#" && word != "//") take(word);  // no units
  }
  ColumnNames found;
  for (const std::string_view word : words) {
    found.list = word.find("[]") != std::string_view::npos;
    if (found.list) break;
    const Role role = role_of(word);
    found.names.push_back(plain_name(word));
    found.x |= role == Role::X;
    found.y |= role == Role::Y;
    found.z |= role == Role::Z;
  }
  return found;
}

/// The first pass.
class Survey {
 public:
  /// `headline`: the number of a line that is no point; 0: none.
  Survey(std::string_view text, const TextStyle& style, std::size_t named, std::size_t headline = 0)
      : text_(text), style_(style), named_(named), headline_(headline) {}

  /// Throws IoError for a line that does not fit the others.
  void run() {
    Lines lines(text_);
    for (std::string_view line; lines.next(line);) {
      number_ = lines.number();
      if (number_ == headline_) continue;
      if (is_comment(line)) {
        if (facts_.rows == 0) consider(line, true);
      } else {
        split(without_comment(line), number_, style_, words_);
        take(line);
      }
    }
    end_block();
    if (facts_.rows == 0) throw IoError("there are no points in it: no line has three numbers");
  }

  const TableFacts& facts() const { return facts_; }

  /// The line of the first point, if it is none: whole numbers alone, of which the first is the number of the
  /// others, which have fractions, as TetGen writes "600 3 0 0" ahead. 0 if it is a point. Throws IoError if
  /// fewer follow that are numbered.
  std::size_t headline() const {
    const bool fractions = std::any_of(facts_.columns.begin(), facts_.columns.end(),
                                       [](const ColumnFacts& c) { return !c.text && !c.whole; });
    if (!first_whole_ || !fractions || facts_.rows < 4 || counted_) return 0;
    const auto follow = static_cast<double>(facts_.rows - 1);
    if (first_count_ > follow && first_count_ < 1e15 && numbered_)
      refuse_count(first_line_, static_cast<long long>(first_count_), facts_.rows - 1);
    return first_count_ == follow ? first_line_ : 0;
  }

  const ColumnNames& header() const { return header_; }
  bool has_header() const { return header_.complete(); }
  bool has_other_header() const { return other_header_; }
  bool counted() const { return counted_; }
  bool ragged() const { return ragged_; }
  bool is_colmap() const { return colmap_; }

  /// Whether the line, in words, is a point; for the second pass.
  bool is_point(std::string_view line, std::size_t number, const std::vector<std::string_view>& words) const {
    return number >= first_line_ && number != headline_ && words.size() >= facts_.columns.size() &&
           number < trailer_ && line != header_line_;
  }

 private:
  void consider(std::string_view line, bool comment) {
    ColumnNames names = names_of(line, style_);
    if (names.complete()) {
      header_ = std::move(names);
      header_is_comment_ = comment;
      if (!comment) header_line_ = line;
      return;
    }
    if (comment) return;
    if (names.x && names.y) refuse(number_, "names columns x and y, but no z; a point needs all three");
    const auto has = [&](const char* whole, const char* part) {
      return std::any_of(names.names.begin(), names.names.end(),
                         [&](const std::string& name) { return name == whole || name == part; });
    };
    degrees_ |= has("latitude", "lat") && (has("longitude", "lon") || has("lng", "long"));
    other_header_ |= names.names.size() >= 3;
  }

  void take(std::string_view line) {
    if (words_.empty()) return;
    if (facts_.rows > 0 && trailer_ == kNone && words_.size() == facts_.columns.size() && parse_row())
      return add_row();
    long long count = 0;
    if (words_.size() == 1 && parse_integer(words_[0], count)) return begin_block(count);
    const auto numbers = std::count_if(words_.begin(), words_.end(), [](std::string_view word) {
      return !word.empty() && number_of(word).has_value();
    });
    if (line == header_line_ && !line.empty()) return;
    if (facts_.rows == 0) {
      if (numbers < 2) return consider(line, false);
      begin_rows();
    }
    if (numbers < 2 && trailer_ == kNone) trailer_ = number_;
    if (numbers < 2) return;
    if (trailer_ != kNone) refuse(trailer_, "is no point, and points follow it; take the line out");
    row();
  }

  /// The first line with numbers says how many columns there are, and which are text.
  void begin_rows() {
    first_line_ = number_;
    if (words_.size() > kMostColumns)
      refuse(number_, "has " + numbered(words_.size(), "word") + "; write one point a line");
    if (degrees_ && named_ == 0)
      refuse(number_,
             "is behind a header of latitudes and longitudes; project them to metres, or name the "
             "columns with --columns");
    if (header_is_comment_ && header_.names.size() != words_.size() && !header_.list) header_ = {};
    std::size_t columns = words_.size();
    if (header_.complete() && header_.names.size() > columns && header_.names.size() != columns)
      refuse(number_, "has " + numbered(columns, "column") + ", and the header names " +
                          std::to_string(header_.names.size()));
    if (header_.list) columns = header_.names.size(), ragged_ = true;
    if (named_ > columns)
      refuse(number_,
             "has " + numbered(columns, "column") + ", and --columns names " + std::to_string(named_));
    facts_.columns.resize(columns);
    for (std::size_t k = 0; k < columns; ++k) facts_.columns[k].text = !number_of(words_[k]);
    if (std::count_if(facts_.columns.begin(), facts_.columns.end(),
                      [](const ColumnFacts& c) { return !c.text; }) < 3)
      refuse(number_, "has fewer than three numbers, and a point needs x, y and z");
    colmap_ = !header_.complete() && looks_like_colmap();
  }

  /// The number of a point, x y z, r g b, an error, and a track of pairs, as COLMAP writes them.
  bool looks_like_colmap() const {
    if (words_.size() < 8 || words_.size() % 2 != 0) return false;
    for (std::size_t k = 0; k < words_.size(); ++k) {
      long long whole = 0;
      const bool is_whole = parse_integer(words_[k], whole);
      if ((k == 0 || k > 7) && !(is_whole && whole >= 0)) return false;
      if (k >= 4 && k <= 6 && !(is_whole && whole >= 0 && whole <= 255)) return false;
    }
    return true;
  }

  void row() {
    const std::size_t columns = facts_.columns.size();
    if (words_.size() != columns && !fits_anyway())
      refuse(number_, "has " + numbered(words_.size(), "column") + ", and line " +
                          std::to_string(first_line_) + " has " + std::to_string(columns));
    if (!parse_row()) refuse(number_, "has " + shown(words_[bad_word_]) + " where others have a number");
    add_row();
  }

  /// False at a word that is no number, bad_word_.
  bool parse_row() {
    values_.resize(facts_.columns.size());
    for (bad_word_ = 0; bad_word_ < values_.size(); ++bad_word_) {
      values_[bad_word_] = NAN;
      if (facts_.columns[bad_word_].text) continue;
      const std::optional<double> value = number_of(words_[bad_word_]);
      if (!value) return false;
      values_[bad_word_] = *value;
    }
    return true;
  }

  void add_row() {
    if (facts_.rows == 0) {
      first_count_ = values_[0];
      first_whole_ = std::all_of(values_.begin(), values_.end(), [](double x) { return std::floor(x) == x; });
    }
    const double expected = facts_.rows == 1 ? (values_[0] == 0 ? 0 : 1) : last_number_ + 1;
    if (facts_.rows > 0) numbered_ = numbered_ && values_[0] == expected;
    last_number_ = values_[0];
    facts_.add(values_, words_);
    ++block_rows_;
  }

  /// Lists at the end may have any length. Makes the columns those of all lines.
  bool fits_anyway() {
    constexpr std::size_t kColmap = 8;
    if (ragged_ || named_ > 0) return words_.size() >= (ragged_ ? facts_.columns.size() : named_) && shrink();
    if (!colmap_ || words_.size() < kColmap || words_.size() % 2 != 0) return false;
    facts_.columns.resize(kColmap);
    ragged_ = true;
    return true;
  }

  bool shrink() {
    if (words_.size() < facts_.columns.size()) facts_.columns.resize(named_);
    return true;
  }

  void begin_block(long long count) {
    if (facts_.rows > 0 && count == static_cast<long long>(facts_.rows) && !counted_) return;  // a trailer
    end_block();
    counted_ = true;
    block_line_ = number_, block_count_ = count, block_rows_ = 0;
  }

  /// The number of points ahead of them is believed, so that a file that is cut off is seen.
  void end_block() {
    if (!counted_ || block_count_ == static_cast<long long>(block_rows_)) return;
    refuse_count(block_line_, block_count_, block_rows_);
  }

  [[noreturn]] static void refuse_count(std::size_t line, long long count, std::size_t rows) {
    refuse(line, "announces " + std::to_string(count) + " points, and " + std::to_string(rows) +
                     " follow: the file is cut off, or take that line out");
  }

  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  std::string_view text_;
  TextStyle style_;
  std::size_t named_;  // columns that the user names
  std::vector<std::string_view> words_;
  std::vector<double> values_;
  std::size_t bad_word_ = 0;
  TableFacts facts_;
  ColumnNames header_;
  bool header_is_comment_ = false, other_header_ = false, degrees_ = false;
  std::string_view header_line_;
  std::size_t number_ = 0, first_line_ = 0, trailer_ = kNone;
  bool counted_ = false, ragged_ = false, colmap_ = false;
  std::size_t headline_;
  double first_count_ = 0, last_number_ = 0;  // the first number of the first point, and of the last
  bool numbered_ = true;                      // do the others count from 0 or 1?
  bool first_whole_ = false;                  // and whether all are whole
  std::size_t block_line_ = 0, block_rows_ = 0;
  long long block_count_ = 0;
};

/// The names of all columns, empty where a column is left out, and what to say of them.
std::vector<std::string> chosen_columns(const Survey& survey, const std::vector<std::string>& given,
                                        Notes& notes) {
  const TableFacts& facts = survey.facts();
  std::vector<std::string> names;
  if (!given.empty()) {
    for (const std::string& name : given) names.push_back(name == "_" ? "" : name);
    names.resize(facts.columns.size());
    return names;
  }
  const bool colmap = survey.is_colmap() && (survey.ragged() || facts.columns.size() == 8);
  if (survey.has_header()) {
    names = survey.header().names;
    // R names the rows, but not the column of their names.
    if (names.size() + 1 == facts.columns.size() && (facts.columns[0].text || facts.columns[0].counts))
      names.insert(names.begin(), "");
    names.resize(facts.columns.size());
    for (std::size_t k = 0; k < names.size(); ++k) {
      const Role role = role_of(names[k]);
      const bool position = names[k] == "x" || names[k] == "y" || names[k] == "z";
      if (facts.columns[k].text && position) throw IoError("its column " + names[k] + " has no numbers");
      const bool of_colmap = survey.ragged() && names[k] == "error";  // of a point, not of the surface
      if (facts.columns[k].text || role == Role::Number || of_colmap) names[k].clear();
    }
    const std::string out = left_out_text(names);
    if (!out.empty()) notes.push_back("left out " + out + "; --columns says otherwise");
    if (survey.ragged()) notes.push_back("the lists at the end of its lines are left out");
    return names;
  }
  names = colmap ? std::vector<std::string>{"", "x", "y", "z", "r", "g", "b", ""}
                 : guessed_columns(facts, survey.counted());
  names.resize(facts.columns.size());
  const std::string out = left_out_text(names);
  if (names.size() > 3 || survey.has_other_header())
    notes.push_back("read " + columns_text(names) + (out.empty() ? "" : ", without " + out) +
                    "; --columns says otherwise");
  return names;
}

/// The type of a column that keeps its numbers; positions have one type.
std::vector<Column> typed(const std::vector<std::string>& names, const TableFacts& facts) {
  constexpr int kSingleDigits = 7;
  bool single = true;
  std::vector<Column> columns;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const ColumnFacts& c = facts.columns[k];
    const Role role = role_of(names[k]);
    if (role == Role::X || role == Role::Y || role == Role::Z) single &= c.single;
    const bool fits = c.least >= INT32_MIN && c.most <= INT32_MAX;
    Scalar type = c.whole && fits             ? Scalar::Int32
                  : c.digits <= kSingleDigits ? Scalar::Float
                                              : Scalar::Double;
    if (role >= Role::Red && role <= Role::Alpha) type = Scalar::Float;  // 1 may be the most, or next to none
    if (role == Role::PackedColour)
      type = c.whole && c.least >= 0 && c.most <= UINT32_MAX ? Scalar::UInt32 : Scalar::Float;
    columns.push_back({c.text ? "" : names[k], type});
  }
  for (Column& column : columns) {
    const Role role = role_of(column.name);
    if (role == Role::X || role == Role::Y || role == Role::Z)
      column.type = single ? Scalar::Float : Scalar::Double;
  }
  return columns;
}

void store(double value, Scalar type, std::uint8_t* to) {
  const auto put = [to](auto number) { std::memcpy(to, &number, sizeof number); };
  if (type == Scalar::Double) return put(value);
  if (type == Scalar::Float) return put(to_float(value));
  type == Scalar::Int32 ? put(static_cast<std::int32_t>(value)) : put(static_cast<std::uint32_t>(value));
}

/// The second pass.
void read_points(std::string_view text, const TextStyle& style, const Survey& survey,
                 const std::vector<Column>& columns, const PointLayout& layout, pcl::PCLPointCloud2& cloud) {
  Lines lines(text);
  std::vector<std::string_view> words;
  std::size_t point = 0;
  const std::size_t points = size_of(cloud);
  for (std::string_view line; point < points && lines.next(line);) {
    if (is_comment(line)) continue;
    split(without_comment(line), lines.number(), style, words);
    if (!survey.is_point(line, lines.number(), words)) continue;
    std::uint8_t* const to = cloud.data.data() + point++ * layout.step();
    for (std::size_t k = 0; k < columns.size(); ++k)
      if (layout.offset(k) != PointLayout::kNowhere)
        store(number_of(words[k]).value_or(NAN), columns[k].type, to + layout.offset(k));
  }
}

}  // namespace

Cloud decode_xyz(std::string_view bytes, const std::vector<std::string>& columns) {
  std::string buffer;
  const std::string_view text = plain_text(bytes, buffer);
  const TextStyle style = style_of(text);
  Survey survey(text, style, columns.size());
  survey.run();
  if (const std::size_t headline = survey.headline(); headline > 0) {
    survey = Survey(text, style, columns.size(), headline);
    survey.run();
  }
  Cloud cloud;
  const std::vector<Column> typed_columns =
      typed(chosen_columns(survey, columns, cloud.notes), survey.facts());
  if (style.decimal_commas) cloud.notes.push_back("read its commas as decimal points");
  const PointLayout layout(typed_columns);
  cloud.points = layout.cloud(survey.facts().rows);
  read_points(text, style, survey, typed_columns, layout, cloud.points);
  layout.finish(cloud.points, cloud.notes);
  return cloud;
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
