// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>

#include "types.h"

namespace filmsticking {

/// The caller's hand on a running reconstruction. All members are optional. Where one of the functions
/// throws, the reconstruction ends with Status::Cancelled and says what was thrown (std::bad_alloc:
/// OutOfMemory).
struct Execution {
  /// Called from the calling thread with the share done, 0 to 1 and never falling, and the room at work.
  std::function<void(double share, const char* room)> progress;

  /// Set it from any thread: the reconstruction ends soon with Status::Cancelled. Most long loops look at it;
  /// the neighbour search, the search for a viewpoint, the local evidence and a step of an evolving film are
  /// ended first.
  const std::atomic<bool>* cancel = nullptr;

  /// Called with the film after every step (0: the initial surface), in the caller's coordinates. A carved
  /// film is one step, and an open depth image none.
  std::function<void(int step, const Mesh& film)> on_step;
};

}  // namespace filmsticking
