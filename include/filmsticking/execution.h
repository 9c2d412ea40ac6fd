// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>

#include "types.h"

namespace filmsticking {

/// Callbacks of a running reconstruction and a request to stop it. All members are optional. If a callback
/// throws, the reconstruction ends with Status::Cancelled and the message of the exception; std::bad_alloc
/// ends it with Status::OutOfMemory.
struct Execution {
  /// Called from the calling thread with the fraction done, 0 to 1 and never falling, and the current stage.
  std::function<void(double share, const char* stage)> progress;

  /// Set to true from any thread: the reconstruction ends soon with Status::Cancelled. Most long loops check
  /// it. The neighbour search, the search for a viewpoint, the local evidence and a film step finish first.
  const std::atomic<bool>* cancel = nullptr;

  /// Called after every film step with the film, in the caller's coordinates; step 0: the surface it starts
  /// from. A closed surface; where it touches itself, vertices share a place. Method::Labelling: after the
  /// steps of its film once with its surface; never for an open depth image.
  std::function<void(int step, const Mesh& film)> on_step;
};

}  // namespace filmsticking
