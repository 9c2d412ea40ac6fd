// SPDX-License-Identifier: GPL-3.0-or-later
// Read by hand: CGAL's reader keeps every corner in a tree, twenty times the memory of the points.
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <ostream>
#include <streambuf>
#include <vector>

#include "codecs.h"
#include "io_error.h"
#include "large_pages.h"
#include "text_scanner.h"
#include "text_table.h"

namespace filmsticking::io {
namespace {

using Vertex = CGAL::Simple_cartesian<double>::Point_3;

constexpr std::size_t kHeader = 84, kTriangle = 50;  // bytes of a binary file

[[noreturn]] void throw_not_whole() { throw IoError("it is not a whole STL file"); }

/// Corners, of which equal ones are one vertex.
template <typename T>
class Corners {
 public:
  /// `most`: a bound on the number of vertices; memory of those that there are not is never touched.
  explicit Corners(std::size_t most) : newest_(kNewest, kFree), slots_(kFirst, kFree) {
    std::size_t slots = kFirst;
    while (slots < most / 3) slots *= 2;  // most often a sixth are vertices
    slots_.reserve(slots);
    prefer_large_pages(slots_.data(), slots * sizeof slots_[0]);
    slots_.resize(slots, kFree);
    constexpr Scalar type = sizeof(T) == sizeof(float) ? Scalar::Float : Scalar::Double;
    cloud_ = PointLayout({{"x", type}, {"y", type}, {"z", type}}).cloud(0);
    cloud_.data.reserve(most * kStep);
    prefer_large_pages(cloud_.data.data(), most * kStep);
  }

  /// The vertex at this place.
  std::int32_t add(const std::array<T, 3>& place) {
    if (!std::all_of(place.begin(), place.end(), [](T x) { return std::isfinite(x); }))
      throw IoError("a corner in it is not finite");
    const std::size_t key = hash(place);
    std::int32_t& newest = newest_[key % kNewest];
    if (newest != kFree && this->place(newest) == place) return newest;
    if (2 * count_ >= slots_.size()) grow();
    std::int32_t& slot = slot_of(place, key);
    if (slot != kFree) return newest = slot;
    if (count_ >= INT32_MAX) throw IoError("it has too many corners");
    const auto* const bytes = reinterpret_cast<const std::uint8_t*>(place.data());
    cloud_.data.insert(cloud_.data.end(), bytes, bytes + kStep);
    return newest = slot = static_cast<std::int32_t>(count_++);
  }

  pcl::PCLPointCloud2 take() {
    cloud_.width = static_cast<std::uint32_t>(count_);
    cloud_.row_step = cloud_.width * cloud_.point_step;
    return std::move(cloud_);
  }

 private:
  static constexpr std::size_t kStep = 3 * sizeof(T), kFirst = 1 << 10, kNewest = 1 << 14;
  static constexpr std::int32_t kFree = -1;

  std::array<T, 3> place(std::int32_t vertex) const {
    return load<std::array<T, 3>>(cloud_.data.data() + kStep * static_cast<std::size_t>(vertex));
  }

  static std::size_t hash(const std::array<T, 3>& place) {
    std::uint64_t h = 0;
    for (const T x : place) {
      const double value = static_cast<double>(x) + 0.0;  // 0 and -0 are equal
      h = (h ^ load<std::uint64_t>(reinterpret_cast<const char*>(&value))) * 0x9e3779b97f4a7c15U;
      h ^= h >> 32;
    }
    return h;
  }

  std::int32_t& slot_of(const std::array<T, 3>& wanted, std::size_t key) {
    std::size_t at = key & (slots_.size() - 1);
    while (slots_[at] != kFree && place(slots_[at]) != wanted) at = (at + 1) & (slots_.size() - 1);
    return slots_[at];
  }

  void grow() {
    slots_.assign(2 * slots_.size(), kFree);
    for (std::size_t i = 0; i < count_; ++i) {
      const auto vertex = static_cast<std::int32_t>(i);
      const std::array<T, 3> at = place(vertex);
      slot_of(at, hash(at)) = vertex;
    }
  }

  pcl::PCLPointCloud2 cloud_;
  std::vector<std::int32_t> newest_;  // a few vertices by the hash of their places, in the processor's cache
  std::vector<std::int32_t> slots_;   // all of them
  std::size_t count_ = 0;
};

Shape decode_binary(std::string_view bytes) {
  const std::size_t count = load<std::uint32_t>(bytes.data() + kHeader - 4);
  Corners<float> corners(3 * count);
  Shape shape;
  shape.triangles.reserve(count);
  const char* at = bytes.data() + kHeader + 3 * sizeof(float);  // past the first normal
  for (std::size_t i = 0; i < count; ++i, at += kTriangle) {
    Triangle triangle{};
    for (std::size_t k = 0; k < 3; ++k)
      triangle[k] = corners.add(load<std::array<float, 3>>(at + k * sizeof(std::array<float, 3>)));
    shape.triangles.push_back(triangle);
  }
  shape.points = corners.take();
  // Materialise's sign of colours in the two bytes behind each triangle.
  if (bytes.substr(0, kHeader).find("COLOR=") != std::string_view::npos)
    shape.notes.push_back("left out the colours of its triangles");
  return shape;
}

class TextFile {
 public:
  explicit TextFile(std::string_view bytes)
      : text_(plain_text(bytes, buffer_)), corners_(text_.size() / kShortest) {}

  Shape decode() {
    Lines lines(text_);
    for (std::string_view text; lines.next(text);) {
      TextScanner line(text, TextScanner::kBlanks);
      number_ = lines.number();
      for (std::string word = lower(line.word()); !word.empty(); word = lower(line.word())) {
        whole_ = word == "endsolid" || (whole_ && word == "solid");
        if (word == "solid" || word == "endsolid") break;  // a name follows
        take(word, line);
      }
    }
    if (!whole_ || !loop_.empty()) throw_not_whole();
    shape_.points = corners_.take();
    return std::move(shape_);
  }

 private:
  static constexpr std::size_t kShortest = sizeof "vertex 0 0 0";

  void take(const std::string& word, TextScanner& line) {
    if (word == "vertex") {
      std::array<double, 3> place{};
      for (double& x : place)
        if (!line.number(x)) refuse("is no corner: it has not three numbers");
      loop_.push_back(corners_.add(place));
    } else if (word == "endloop") {
      if (loop_.size() < 3) refuse("ends a triangle of fewer than three corners");
      append_polygon(loop_, shape_.triangles);
      loop_.clear();
    }
  }

  [[noreturn]] void refuse(const std::string& what) const {
    throw IoError("line " + std::to_string(number_) + " " + what);
  }

  std::string buffer_;
  std::string_view text_;
  Corners<double> corners_;
  Shape shape_;
  std::vector<std::int32_t> loop_;
  std::size_t number_ = 0;
  bool whole_ = false;
};

/// Passes its output on to a ByteWriter.
class WriterBuffer : public std::streambuf {
 public:
  explicit WriterBuffer(ByteWriter& out) : out_(out) {}

 protected:
  std::streamsize xsputn(const char* bytes, std::streamsize size) override {
    out_.append({bytes, static_cast<std::size_t>(size)});
    return size;
  }
  int_type overflow(int_type c) override {
    const char byte = traits_type::to_char_type(c);
    if (!traits_type::eq_int_type(c, traits_type::eof())) out_.append({&byte, 1});
    return traits_type::not_eof(c);
  }

 private:
  ByteWriter& out_;
};

}  // namespace

/// Binary files have a size that follows from their number of triangles; some begin with "solid" like texts,
/// some have more at their end.
Shape decode_stl(std::string_view bytes) {
  const std::size_t size = bytes.size() < kHeader
                               ? kHeader
                               : kHeader + kTriangle * std::size_t{load<std::uint32_t>(bytes.data() + 80)};
  const bool text = bytes.size() != size && bytes.substr(0, 5) == "solid";
  if (!text && bytes.size() < size) throw_not_whole();
  Shape shape = text ? TextFile(bytes).decode() : decode_binary(bytes);
  if (shape.triangles.empty()) throw_not_whole();
  return shape;
}

void encode_stl(const pcl::PCLPointCloud2& vertices, const std::vector<Triangle>& triangles,
                ByteWriter& out) {
  std::vector<Vertex> corners;
  corners.reserve(size_of(vertices));
  for (const Point& p : positions_of(vertices)) corners.emplace_back(p[0], p[1], p[2]);
  WriterBuffer buffer(out);
  std::ostream file(&buffer);
  file.exceptions(std::ios::badbit);  // passes on what the sink throws
  CGAL::IO::set_mode(file, float_exact(vertices) ? CGAL::IO::BINARY : CGAL::IO::ASCII);
  CGAL::IO::write_STL(file, corners, triangles, CGAL::parameters::stream_precision(17));
}

}  // namespace filmsticking::io
