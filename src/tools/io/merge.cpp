// SPDX-License-Identifier: GPL-3.0-or-later
#include "merge.h"

#include <algorithm>
#include <cstring>
#include <set>
#include <string>
#include <utility>

#include "bytes.h"
#include "io_error.h"

namespace filmsticking::io {
namespace {

using Type = pcl::PCLPointField;

bool is_position(const std::string& name) { return name == "x" || name == "y" || name == "z"; }
bool is_colour(const std::string& name) { return name == "rgb" || name == "rgba"; }

/// Rgba is rgb of the same bytes.
const pcl::PCLPointField* same_field(const pcl::PCLPointCloud2& cloud, const pcl::PCLPointField& field) {
  for (const char* name : {"rgb", "rgba"})
    if (is_colour(field.name) && size_of(Scalar{field.datatype}) == 4)
      if (const auto* found = find_field(cloud, name); found && size_of(Scalar{found->datatype}) == 4)
        return found;
  const auto* found = find_field(cloud, field.name.c_str());
  return found && found->datatype == field.datatype && found->count == field.count ? found : nullptr;
}

/// Every point with its own viewpoint, if that is known.
void spread_viewpoint(Cloud& cloud) {
  if (!cloud.viewpoint || !cloud.viewpoints.empty() || size_of(cloud.points) == 0) return;
  cloud.points = with_stations(cloud.points, std::vector<Point>(size_of(cloud.points), *cloud.viewpoint));
  cloud.viewpoints = viewpoints_of(cloud.points);
}

struct Copy {
  const pcl::PCLPointField *first, *second;
  std::size_t to, size;
};

void copy_points(const pcl::PCLPointCloud2& from, bool second, const std::vector<Copy>& copies,
                 const PositionFields& to_positions, std::size_t step, std::uint8_t* to) {
  const PositionFields positions(from);
  for (std::size_t i = 0; i < size_of(from); ++i, to += step) {
    const std::uint8_t* const point = bytes_of(from, i);
    to_positions.store(positions.load(point), to);
    for (const Copy& copy : copies)
      std::memcpy(to + copy.to, point + (second ? copy.second : copy.first)->offset, copy.size);
  }
}

}  // namespace

void append(Cloud& cloud, Cloud other) {
  if (cloud.viewpoint != other.viewpoint || !cloud.viewpoints.empty() || !other.viewpoints.empty()) {
    spread_viewpoint(cloud);
    spread_viewpoint(other);
    cloud.viewpoint.reset();
  }
  const bool single = PositionFields(cloud.points).single() && PositionFields(other.points).single();
  const std::size_t size = single ? sizeof(float) : sizeof(double);
  std::vector<pcl::PCLPointField> fields;
  for (const char* axis : {"x", "y", "z"})
    fields.push_back(make_field(axis, size * fields.size(), single ? Type::FLOAT32 : Type::FLOAT64));
  std::size_t step = 3 * size;
  std::vector<Copy> copies;
  std::set<std::string> lost;
  for (const pcl::PCLPointField& field : cloud.points.fields) {
    if (is_position(field.name)) continue;
    const pcl::PCLPointField* const same = same_field(other.points, field);
    const std::size_t bytes = size_of(Scalar{field.datatype}) * std::max(1U, field.count);
    if (!same) {
      lost.insert(field.name);
      continue;
    }
    copies.push_back({&field, same, step, bytes});
    fields.push_back(
        make_field(same->name == field.name ? field.name : "rgb", step, field.datatype, field.count));
    step += bytes;
  }
  for (const pcl::PCLPointField& field : other.points.fields)
    if (!is_position(field.name) && !same_field(cloud.points, field)) lost.insert(field.name);
  std::string names;
  for (const std::string& name : lost)
    if (!is_station(name)) names += (names.empty() ? "" : ", ") + name;
  pcl::PCLPointCloud2 both = make_rows(fields, step, size_of(cloud.points) + size_of(other.points));
  const PositionFields positions(both);
  copy_points(cloud.points, false, copies, positions, step, both.data.data());
  copy_points(other.points, true, copies, positions, step, both.data.data() + size_of(cloud.points) * step);
  both.header = cloud.points.header;
  cloud.points = std::move(both);
  cloud.viewpoints = viewpoints_of(cloud.points);
  cloud.notes = std::move(other.notes);
  if (!names.empty()) cloud.notes.push_back("left out the fields " + names + ", which not all files have");
}

}  // namespace filmsticking::io
