// SPDX-License-Identifier: GPL-3.0-or-later
// The former type of io::PositionFields.
#pragma once

#include <array>

#include "io/cloud.h"

namespace filmsticking::filters {

class PositionFields : public io::PositionFields {
 public:
  using io::PositionFields::PositionFields;

  std::array<float, 3> load(const std::uint8_t* point) const {
    const Point p = io::PositionFields::load(point);
    return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
  }
};

}  // namespace filmsticking::filters
