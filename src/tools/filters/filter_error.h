// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

namespace filmsticking::filters {

/// A filter that is asked for what it cannot do; what() is a clause for the user.
struct FilterError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace filmsticking::filters
