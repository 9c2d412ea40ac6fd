// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

namespace filmsticking::filters {

/// An impossible request to a filter; what() is a clause for the user.
struct FilterError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace filmsticking::filters
