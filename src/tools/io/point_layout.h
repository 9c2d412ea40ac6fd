// SPDX-License-Identifier: GPL-3.0-or-later
// From the columns of a file to the fields of points, for all formats.
#pragma once

#include <pcl/PCLPointCloud2.h>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "bytes.h"

namespace filmsticking::io {

/// Sentences to the user of what a file has and how it was read; each ends without a full stop.
using Notes = std::vector<std::string>;

/// A column as a file describes it.
struct Column {
  std::string name;
  Scalar type = Scalar::Float;
  std::size_t count = 1;  ///< values a point
};

/// Gives every column its place in a point: x, y and z first, then the others in the order of the file, under
/// PCL's names. Coordinates of other types than FLOAT32 or FLOAT64 become FLOAT64. Red, green and blue of any
/// types become the field rgb, with alpha rgba.
///
/// A reader puts the values of a column, as its own type, to offset(); then finish() converts.
class PointLayout {
 public:
  /// Throws IoError where x, y or z is missing.
  explicit PointLayout(const std::vector<Column>& columns);

  /// Where the values of a column go in a point; kNowhere if they are not kept.
  std::size_t offset(std::size_t column) const { return offsets_[column]; }
  static constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);

  std::size_t step() const { return step_; }  ///< bytes of a point

  /// Points of zeros. Throws IoError for too many.
  pcl::PCLPointCloud2 cloud(std::size_t points) const;

  /// Converts coordinates and colours. Columns whose names others have are left out, with a note. Colours are
  /// whole bytes, 16 bits where one is above 255, or real numbers where none is above 1. Others are left out,
  /// with a note.
  void finish(pcl::PCLPointCloud2& cloud, Notes& notes) const;

  /// Copies all points of a body whose points are the columns, one after the other, and calls finish().
  /// Throws IoError if the body is shorter.
  pcl::PCLPointCloud2 read(std::string_view body, std::size_t points, bool big_endian, Notes& notes) const;

 private:
  /// Values that finish() converts.
  struct Raw {
    std::size_t offset = kNowhere;
    Scalar type = Scalar::Float;
  };
  using Triple = std::array<std::size_t, 3>;

  void add(std::size_t column, const std::string& name);
  void add_positions(const Triple& axes);
  void add_colour(const Triple& channels, std::size_t alpha);
  void add_colour_list(std::size_t column);
  std::size_t add_field(const std::string& name, Scalar type, std::size_t count = 1);
  std::size_t reserve(Scalar type, std::size_t count = 1);
  void convert_colours(pcl::PCLPointCloud2& cloud, Notes& notes) const;
  void copy(std::string_view body, pcl::PCLPointCloud2& cloud) const;
  void turn_bytes(pcl::PCLPointCloud2& cloud) const;

  std::vector<Column> columns_;
  std::vector<std::size_t> offsets_;
  std::vector<std::string> twice_;  // names of columns that are left out, as others have them
  std::vector<pcl::PCLPointField> fields_;
  std::size_t step_ = 0;
  std::array<Raw, 3> raw_axes_;    // set where coordinates are converted
  std::vector<Raw> raw_channels_;  // red, green, blue, alpha, where they are converted
  std::size_t colour_ = kNowhere;  // blue, green, red, alpha
  bool opaque_ = false;            // alpha is to be 255
};

/// Notes that a body has bytes for more points, of `step` bytes, than its header says.
void note_more(std::size_t body, std::size_t points, std::size_t step, Notes& notes);

/// The cloud with its fields as PointLayout makes them, whatever their names and types, in one row if any had
/// to change. Throws IoError for one whose bytes contradict its fields.
pcl::PCLPointCloud2 with_known_fields(pcl::PCLPointCloud2 cloud, Notes& notes);

}  // namespace filmsticking::io
