// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>

#include "filmsticking/status.h"

namespace filmsticking {

/// Why there is no mesh. Thrown inside the library only: reconstruct() turns it into a Result.
struct Failure {
  Status status;
  std::string message;  ///< one sentence

  Failure(Status why, std::string sentence) : status(why), message(std::move(sentence)) {}
  explicit Failure(Status why) : Failure(why, describe(why)) {}
};

}  // namespace filmsticking
