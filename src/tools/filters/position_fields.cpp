// SPDX-License-Identifier: GPL-3.0-or-later
#include "position_fields.h"

#include <string>

#include "filter_error.h"

namespace filmsticking::filters {

PositionFields::PositionFields(const pcl::PCLPointCloud2& cloud) {
  const char* const names[3] = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    const pcl::PCLPointField* found = nullptr;
    for (const pcl::PCLPointField& field : cloud.fields)
      if (field.name == names[axis]) found = &field;
    if (found == nullptr) throw FilterError(std::string("the cloud has no field ") + names[axis]);
    if (found->datatype != pcl::PCLPointField::FLOAT32)
      throw FilterError(std::string("the cloud's field ") + names[axis] + " is not of single precision");
    if (std::size_t{found->offset} + sizeof(float) > cloud.point_step)
      throw FilterError(std::string("the cloud's field ") + names[axis] + " is not within its points");
    offsets_[axis] = found->offset;
  }
}

}  // namespace filmsticking::filters
