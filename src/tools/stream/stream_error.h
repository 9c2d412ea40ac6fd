// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

namespace filmsticking::stream {

/// A source, a trajectory, a message or a frame that cannot be used; what() is a clause for the user.
struct StreamError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace filmsticking::stream
