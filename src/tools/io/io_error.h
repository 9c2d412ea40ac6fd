// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>

namespace filmsticking::io {

/// A file that cannot be read or written; what() is a clause for the user, without the file's name.
struct IoError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace filmsticking::io
