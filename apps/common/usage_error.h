// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

namespace filmsticking::app {

/// A wrong command line; what() is a sentence for the user, without its full stop.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace filmsticking::app
