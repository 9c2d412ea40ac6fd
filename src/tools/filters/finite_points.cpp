// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "position_fields.h"
#include "steps.h"

namespace filmsticking::filters {
namespace {

bool is_finite(const std::array<float, 3>& position) {
  return std::all_of(position.begin(), position.end(), [](float x) { return std::isfinite(x); });
}

bool is_in(const Box& box, const std::array<float, 3>& position) {
  for (int axis = 0; axis < 3; ++axis)
    if (!(box.least[axis] <= position[axis] && position[axis] <= box.most[axis])) return false;
  return true;
}

}  // namespace

pcl::PCLPointCloud2 finite_points(const pcl::PCLPointCloud2& cloud, const std::optional<Box>& box) {
  if (cloud.is_bigendian) throw FilterError("the cloud's numbers are big-endian");
  const PositionFields fields(cloud);
  const std::size_t step = cloud.point_step, width = cloud.width;
  // A cloud of one row may leave row_step out.
  const std::size_t row_step = cloud.height > 1 ? std::size_t{cloud.row_step} : width * step;
  if (row_step < width * step || cloud.data.size() < row_step * cloud.height)
    throw FilterError("the cloud has fewer bytes than its width and height say");

  pcl::PCLPointCloud2 kept;
  kept.header = cloud.header;
  kept.fields = cloud.fields;
  kept.is_bigendian = cloud.is_bigendian;
  kept.point_step = cloud.point_step;
  kept.is_dense = 1;
  for (std::size_t row = 0; row < cloud.height; ++row)
    for (std::size_t column = 0; column < width; ++column) {
      const std::uint8_t* point = cloud.data.data() + row * row_step + column * step;
      const std::array<float, 3> position = fields.load(point);
      if (is_finite(position) && (!box || is_in(*box, position)))
        kept.data.insert(kept.data.end(), point, point + step);
    }
  kept.height = 1;
  kept.width = static_cast<std::uint32_t>(kept.data.size() / step);
  kept.row_step = static_cast<std::uint32_t>(kept.data.size());
  return kept;
}

}  // namespace filmsticking::filters
