// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <limits>

namespace filmsticking {

/// Thrown inside the library when the caller asked to stop; never leaves it.
struct Cancelled {};

/// Thrown by a triangulation that grew past what it was allowed.
struct TooManyTetrahedra {};

/// The caller's wish to stop, for loops that take long: cancel() throws Cancelled once it is there.
struct Cancel {
  const std::atomic<bool>* wish = nullptr;

  void operator()() const {
    if (wish != nullptr && wish->load(std::memory_order_relaxed)) throw Cancelled{};
  }
};

/// What a triangulation may take.
struct TriangulationLimits {
  std::int64_t tetrahedra = std::numeric_limits<std::int64_t>::max();
  Cancel cancel;
};

}  // namespace filmsticking
