// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <limits>

namespace filmsticking {

/// Thrown inside the library when the caller asked to stop. Never leaves it.
struct Cancelled {};

/// Thrown by a triangulation with more tetrahedra than its limit.
struct TooManyTetrahedra {};

/// The request to stop, for long loops: cancel() throws Cancelled once the caller has set it.
struct Cancel {
  const std::atomic<bool>* wish = nullptr;

  void operator()() const {
    if (wish != nullptr && wish->load(std::memory_order_relaxed)) throw Cancelled{};
  }
};

/// Limits of a triangulation.
struct TriangulationLimits {
  std::int64_t tetrahedra = std::numeric_limits<std::int64_t>::max();
  Cancel cancel;
};

}  // namespace filmsticking
