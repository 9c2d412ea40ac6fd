// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_layout.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "cloud.h"
#include "field_role.h"
#include "io_error.h"

namespace filmsticking::io {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

bool is_byte(const Column& column) { return column.type == Scalar::UInt8 && column.count == 1; }

/// The first column of this role, and of this family if one is asked for. Only single values have roles.
std::size_t column_of(const std::vector<Column>& columns, Role role, std::size_t family = kNone) {
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (columns[c].count == 1 && role_of(columns[c].name) == role &&
        (family == kNone || family_of(columns[c].name) == family))
      return c;
  return kNone;
}

/// The columns of three roles in a row: of names that belong together if there are such; or else the first
/// ones.
std::array<std::size_t, 3> triple_of(const std::vector<Column>& columns, Role first) {
  const auto of_family = [&](std::size_t family) {
    std::array<std::size_t, 3> triple{};
    for (std::size_t k = 0; k < 3; ++k)
      triple[k] = column_of(columns, static_cast<Role>(static_cast<std::size_t>(first) + k), family);
    return triple;
  };
  for (std::size_t family = 0; family < kFamilies; ++family) {
    const auto triple = of_family(family);
    if (std::find(triple.begin(), triple.end(), kNone) == triple.end()) return triple;
  }
  return of_family(kNone);
}

/// Reverses the bytes of a number.
template <typename Bits>
void turn(std::uint8_t* value) {
  const auto bits = load_big<Bits>(value);
  std::memcpy(value, &bits, sizeof bits);
}

void turn(std::uint8_t* value, std::size_t size) {
  if (size == 2) turn<std::uint16_t>(value);
  if (size == 4) turn<std::uint32_t>(value);
  if (size == 8) turn<std::uint64_t>(value);
}

/// From a channel's values to bytes.
struct ColourScale {
  bool possible = true;
  double factor = 1;
};

ColourScale colour_scale(double least, double most, bool real) {
  if (!(least >= 0 && most <= 65535)) return {false, 1};
  if (most > 255) return {true, 1.0 / 257};  // 65535 becomes 255
  return {true, real && most <= 1 ? 255.0 : 1.0};
}

}  // namespace

PointLayout::PointLayout(const std::vector<Column>& columns)
    : columns_(columns), offsets_(columns.size(), kNowhere) {
  const auto complete = [](const Triple& all) {
    return std::find(all.begin(), all.end(), kNone) == all.end();
  };
  const Triple axes = triple_of(columns, Role::X);
  if (!complete(axes)) throw IoError("its points have no x, y and z");
  add_positions(axes);
  const Triple channels = triple_of(columns, Role::Red), normals = triple_of(columns, Role::NormalX);
  const bool coloured = complete(channels);
  const std::size_t alpha =
      coloured ? column_of(columns, Role::Alpha, family_of(columns[channels[0]].name)) : kNone;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (offsets_[c] != kNowhere || std::find(axes.begin(), axes.end(), c) != axes.end()) continue;
    const bool is_channel = std::find(channels.begin(), channels.end(), c) != channels.end();
    if (coloured && (is_channel || c == alpha)) {
      if (colour_ == kNowhere) add_colour(channels, alpha);
      continue;
    }
    if (!coloured && role_of(columns[c].name) == Role::PackedColour && columns[c].count > 2 &&
        columns[c].count < 5 && colour_ == kNowhere) {
      add_colour_list(c);
      continue;
    }
    const bool is_normal = complete(normals) && std::find(normals.begin(), normals.end(), c) != normals.end();
    const Role role = role_of(columns[c].name);
    const bool renamed =
        is_normal || role == Role::ViewpointX || role == Role::ViewpointY || role == Role::ViewpointZ;
    add(c, renamed ? field_name(role, columns[c].name) : columns[c].name);
  }
}

std::size_t PointLayout::reserve(Scalar type, std::size_t count) {
  const std::size_t offset = step_;
  step_ += size_of(type) * count;
  return offset;
}

std::size_t PointLayout::add_field(const std::string& name, Scalar type, std::size_t count) {
  fields_.push_back(make_field(name, step_, static_cast<std::uint8_t>(type), count));
  return reserve(type, count);
}

void PointLayout::add(std::size_t column, const std::string& name) {
  const Column& c = columns_[column];
  const bool known = std::any_of(fields_.begin(), fields_.end(),
                                 [&](const pcl::PCLPointField& field) { return field.name == name; });
  if (known && !name.empty()) twice_.push_back(name);
  if (known || name.empty()) return;
  offsets_[column] = add_field(name, c.type, c.count);
}

void PointLayout::add_positions(const Triple& axes) {
  constexpr const char* kNames[3] = {"x", "y", "z"};
  bool direct = false;
  for (const Scalar type : {Scalar::Float, Scalar::Double})
    direct |= std::all_of(axes.begin(), axes.end(), [&](std::size_t c) { return columns_[c].type == type; });
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t offset = add_field(kNames[k], direct ? columns_[axes[k]].type : Scalar::Double);
    if (direct) offsets_[axes[k]] = offset;
  }
  for (std::size_t k = 0; k < 3 && !direct; ++k) {
    offsets_[axes[k]] = reserve(columns_[axes[k]].type);
    raw_axes_[k] = {offsets_[axes[k]], columns_[axes[k]].type};
  }
}

void PointLayout::add_colour(const Triple& channels, std::size_t alpha) {
  const bool has_alpha = alpha != kNone;
  std::vector<std::size_t> all(channels.begin(), channels.end());
  if (has_alpha) all.push_back(alpha);
  colour_ = has_alpha ? add_field("rgba", Scalar::UInt32) : add_field("rgb", Scalar::Float);
  opaque_ = !has_alpha;
  const bool direct =
      std::all_of(all.begin(), all.end(), [&](std::size_t c) { return is_byte(columns_[c]); });
  constexpr std::size_t kPlaces[4] = {2, 1, 0, 3};
  for (std::size_t k = 0; k < all.size(); ++k) {
    offsets_[all[k]] = direct ? colour_ + kPlaces[k] : reserve(columns_[all[k]].type);
    if (!direct) raw_channels_.push_back({offsets_[all[k]], columns_[all[k]].type});
  }
}

/// One column of red, green, blue, or alpha as well.
void PointLayout::add_colour_list(std::size_t column) {
  const Column& list = columns_[column];
  opaque_ = list.count == 3;
  colour_ = opaque_ ? add_field("rgb", Scalar::Float) : add_field("rgba", Scalar::UInt32);
  offsets_[column] = reserve(list.type, list.count);
  for (std::size_t k = 0; k < list.count; ++k)
    raw_channels_.push_back({offsets_[column] + k * size_of(list.type), list.type});
}

pcl::PCLPointCloud2 PointLayout::cloud(std::size_t points) const { return make_rows(fields_, step_, points); }

void PointLayout::finish(pcl::PCLPointCloud2& cloud, Notes& notes) const {
  const std::size_t end = cloud.data.size();
  std::uint8_t* const data = cloud.data.data();
  if (raw_axes_[0].offset != kNowhere)
    for (std::size_t at = 0; at < end; at += step_)
      for (std::size_t k = 0; k < 3; ++k) {
        const double x = load(data + at + raw_axes_[k].offset, raw_axes_[k].type);
        std::memcpy(data + at + k * sizeof x, &x, sizeof x);
      }
  if (opaque_)
    for (std::size_t at = colour_ + 3; at < end; at += step_) data[at] = 255;
  if (!raw_channels_.empty()) convert_colours(cloud, notes);
  for (const std::string& name : twice_) notes.push_back("left out the second '" + name + "'");
}

void PointLayout::convert_colours(pcl::PCLPointCloud2& cloud, Notes& notes) const {
  std::uint8_t* const data = cloud.data.data();
  const std::size_t end = cloud.data.size();
  double least = 0, most = 0, alpha = 0;
  bool real = true;
  for (std::size_t k = 0; k < raw_channels_.size(); ++k) {
    const Raw& channel = raw_channels_[k];
    if (k < 3) real &= channel.type == Scalar::Float || channel.type == Scalar::Double;
    for (std::size_t at = 0; at < end; at += step_) {
      const double value = load(data + at + channel.offset, channel.type);
      if (k == 3) {
        alpha = std::max(alpha, value);
      } else if (!std::isnan(value)) {
        least = std::min(least, value), most = std::max(most, value);
      }
    }
  }
  const ColourScale scale = colour_scale(least, most, real);
  if (!scale.possible) {
    cloud.fields.erase(std::remove_if(cloud.fields.begin(), cloud.fields.end(),
                                      [&](const auto& field) { return field.offset == colour_; }),
                       cloud.fields.end());
    notes.push_back("its colours are left out: they are neither from 0 to 1, nor to 255, nor to 65535");
    return;
  }
  const double alpha_factor = alpha > 255 ? 1.0 / 257 : alpha <= 1 ? 255.0 : 1.0;
  constexpr std::size_t kPlaces[4] = {2, 1, 0, 3};
  for (std::size_t at = 0; at < end; at += step_)
    for (std::size_t k = 0; k < raw_channels_.size(); ++k) {
      const double value = load(data + at + raw_channels_[k].offset, raw_channels_[k].type);
      const double byte = std::floor(value * (k == 3 ? alpha_factor : scale.factor) + 0.5);
      data[at + colour_ + kPlaces[k]] = static_cast<std::uint8_t>(byte >= 0 ? std::min(byte, 255.0) : 0);
    }
}

/// Columns that lie side by side in the file and in the point are copied at once.
void PointLayout::copy(std::string_view body, pcl::PCLPointCloud2& cloud) const {
  struct Run {
    std::size_t from, to, size;
  };
  std::vector<Run> runs;
  std::size_t record = 0;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    const std::size_t size = size_of(columns_[c].type) * columns_[c].count;
    if (offsets_[c] != kNowhere) {
      if (!runs.empty() && runs.back().from + runs.back().size == record &&
          runs.back().to + runs.back().size == offsets_[c]) {
        runs.back().size += size;
      } else {
        runs.push_back({record, offsets_[c], size});
      }
    }
    record += size;
  }
  const std::size_t points = size_of(cloud);
  if (record > 0 && points > body.size() / record) throw IoError("it ends before its header says");
  std::uint8_t* to = cloud.data.data();
  if (runs.size() == 1 && runs[0].size == record && record == step_) {
    if (points > 0) std::memcpy(to, body.data(), points * record);
    return;
  }
  const char* from = body.data();
  for (std::size_t i = 0; i < points; ++i, from += record, to += step_)
    for (const Run& run : runs) std::memcpy(to + run.to, from + run.from, run.size);
}

void PointLayout::turn_bytes(pcl::PCLPointCloud2& cloud) const {
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    const std::size_t size = size_of(columns_[c].type);
    if (offsets_[c] == kNowhere || size == 1) continue;
    for (std::size_t at = offsets_[c]; at < cloud.data.size(); at += step_)
      for (std::size_t k = 0; k < columns_[c].count; ++k) {
        turn(cloud.data.data() + at + k * size, size);
      }
  }
}

pcl::PCLPointCloud2 PointLayout::read(std::string_view body, std::size_t points, bool big_endian,
                                      Notes& notes) const {
  pcl::PCLPointCloud2 read = cloud(points);
  copy(body, read);
  if (big_endian) turn_bytes(read);
  finish(read, notes);
  return read;
}

void note_more(std::size_t body, std::size_t points, std::size_t step, Notes& notes) {
  const std::size_t more = body / std::max<std::size_t>(step, 1) - points;  // read() saw that many points
  if (more > 0)
    notes.push_back("left out " + std::to_string(body - points * step) +
                    " bytes behind its points, as many as " + std::to_string(more) +
                    " points more than its header says have");
}

pcl::PCLPointCloud2 with_known_fields(pcl::PCLPointCloud2 cloud, Notes& notes) {
  std::vector<Column> columns;
  for (const pcl::PCLPointField& field : cloud.fields) {
    const auto type = static_cast<Scalar>(field.datatype);
    columns.push_back({size_of(type) == 0 ? "" : field.name, type, std::max<std::size_t>(field.count, 1)});
  }
  const PointLayout layout(columns);
  const pcl::PCLPointCloud2 empty = layout.cloud(0);
  const auto kept = [&](const pcl::PCLPointField& wanted) {
    return std::any_of(cloud.fields.begin(), cloud.fields.end(), [&](const pcl::PCLPointField& field) {
      return field.name == wanted.name && field.datatype == wanted.datatype;
    });
  };
  if (std::all_of(empty.fields.begin(), empty.fields.end(), kept)) return cloud;
  check_fields(cloud);
  pcl::PCLPointCloud2 known = layout.cloud(size_of(cloud));
  known.header = cloud.header;
  std::uint8_t* to = known.data.data();
  for (std::size_t i = 0; i < size_of(cloud); ++i, to += layout.step())
    for (std::size_t c = 0; c < columns.size(); ++c)
      if (layout.offset(c) != PointLayout::kNowhere)
        std::memcpy(to + layout.offset(c), bytes_of(cloud, i) + cloud.fields[c].offset,
                    size_of(columns[c].type) * columns[c].count);
  layout.finish(known, notes);
  return known;
}

}  // namespace filmsticking::io
