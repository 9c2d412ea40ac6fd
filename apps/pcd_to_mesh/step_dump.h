// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "filmsticking/types.h"

namespace filmsticking::app {

/// Writes the film after each step; a file that cannot be written stops the run.
class StepDump {
 public:
  explicit StepDump(std::string folder) : folder_(std::move(folder)) {}

  void write(int step, const Mesh& film) noexcept;

  /// Why a file could not be written; empty if all were.
  const std::string& error() const { return error_; }

 private:
  std::string folder_;
  std::string error_;
};

}  // namespace filmsticking::app
