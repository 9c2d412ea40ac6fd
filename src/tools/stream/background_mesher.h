// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "filmsticking/reconstruct.h"
#include "io/model.h"

namespace filmsticking::capture {

/// Reconstructs on a thread of its own, one cloud at a time; what comes while it is at work is not queued, so
/// that it never falls behind.
class BackgroundMesher {
 public:
  /// What it tells, from its own thread; neither may throw.
  struct Listener {
    std::function<void(double share, const char* room)> progress;
    std::function<void(std::size_t frames, const io::Model& cloud, const Result& result)> done;
  };

  BackgroundMesher(const Options& options, Listener listener);
  ~BackgroundMesher();  ///< cancels what is at work
  BackgroundMesher(const BackgroundMesher&) = delete;
  BackgroundMesher& operator=(const BackgroundMesher&) = delete;

  bool idle() const;

  /// Takes the cloud of so many frames if it is idle.
  bool offer(std::size_t frames, io::Model cloud);

  /// Waits until it is idle.
  void wait();

 private:
  struct Job {
    std::size_t frames;
    io::Model cloud;
  };
  void work();

  Options options_;
  Listener listener_;
  std::atomic<bool> cancel_{false};
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Job> job_;  ///< there until it is done
  bool end_ = false;
  std::thread thread_;  // last: it uses the others
};

}  // namespace filmsticking::capture
