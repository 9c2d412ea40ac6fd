// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

namespace filmsticking::capture {

/// A source, a trajectory or a frame that cannot be used; what() is a clause for the user.
struct CaptureError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace filmsticking::capture
