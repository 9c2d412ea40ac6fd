// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pcl/PCLPointCloud2.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace filmsticking::filters {

/// Where x, y and z are in the bytes of a point.
class PositionFields {
 public:
  /// Throws FilterError unless x, y, z are there, of single precision, and within a point's bytes.
  explicit PositionFields(const pcl::PCLPointCloud2& cloud);

  std::array<float, 3> load(const std::uint8_t* point) const {
    std::array<float, 3> position;
    for (int axis = 0; axis < 3; ++axis) std::memcpy(&position[axis], point + offsets_[axis], sizeof(float));
    return position;
  }

  void store(const std::array<float, 3>& position, std::uint8_t* point) const {
    for (int axis = 0; axis < 3; ++axis) std::memcpy(point + offsets_[axis], &position[axis], sizeof(float));
  }

 private:
  std::array<std::size_t, 3> offsets_{};
};

}  // namespace filmsticking::filters
