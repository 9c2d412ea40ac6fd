// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <chrono>
#include <exception>
#include <new>
#include <string>
#include <utility>

#include "filmsticking/execution.h"
#include "filmsticking/report.h"
#include "geometry/work_limits.h"

namespace filmsticking {

/// Thrown inside the library when a callback of the caller threw. Never leaves it.
struct CallbackThrew {
  std::string what;
};

/// Runs a callback of the caller. Turns what it throws into CallbackThrew, so that it is not taken for a
/// failure of the library; std::bad_alloc passes.
template <class Call>
void call_back(const Call& call) {
  try {
    call();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw CallbackThrew{error.what()};
  } catch (...) {
    throw CallbackThrew{"an exception of unknown type"};
  }
}

/// Measures the time per stage, reports progress to the caller and checks for a request to stop.
class Monitor {
 public:
  Monitor(const Execution& execution, Report& report) : execution_(execution), report_(report) {}
  Monitor(Execution&&, Report&) = delete;  // it would outlive its execution
  ~Monitor() { leave(); }
  Monitor(const Monitor&) = delete;
  Monitor& operator=(const Monitor&) = delete;

  /// Ends the current stage and starts another. `share`: fraction of the work done, 0 to 1. Throws Cancelled,
  /// CallbackThrew.
  void enter(const char* stage, double share) {
    leave();
    auto it = std::find_if(report_.rooms.begin(), report_.rooms.end(),
                           [&](const RoomSeconds& r) { return r.room == stage; });
    if (it == report_.rooms.end()) it = report_.rooms.insert(report_.rooms.end(), {stage, 0});
    index_ = it - report_.rooms.begin();
    start_ = Clock::now();
    stage_ = stage;
    progress(share);
  }

  void progress(double share) {
    cancel()();
    share_ = std::max(share_, std::min(share, 1.0));
    if (execution_.progress) call_back([&] { execution_.progress(share_, stage_); });
  }

  double share() const { return share_; }
  Cancel cancel() const { return {execution_.cancel}; }
  const Execution& execution() const { return execution_; }

 private:
  using Clock = std::chrono::steady_clock;
  void leave() {
    if (index_ < 0) return;
    report_.rooms[static_cast<std::size_t>(index_)].seconds +=
        std::chrono::duration<double>(Clock::now() - start_).count();
    index_ = -1;
  }

  const Execution& execution_;
  Report& report_;
  std::ptrdiff_t index_ = -1;
  Clock::time_point start_;
  const char* stage_ = "";
  double share_ = 0;
};

}  // namespace filmsticking
