// SPDX-License-Identifier: GPL-3.0-or-later
// From a stream of frames to meshes: what a node does, without the middleware.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "filmsticking/options.h"
#include "filmsticking/report.h"
#include "filmsticking/status.h"
#include "filters/filter_options.h"
#include "io/model.h"
#include "live_accumulator.h"
#include "newest_wins.h"

namespace filmsticking::stream {

/// Everything that can be chosen, at any time.
struct Settings {
  Bounds bounds;                   ///< of what is held
  int every_frames = 1;            ///< reconstruct when so many frames came; 0: not by their number
  double every_seconds = 0;        ///< reconstruct when so much time went by and frames came; 0: not by time
  bool cancel_outdated = false;    ///< end a running reconstruction when there is newer data
  filters::FilterOptions filters;  ///< run on all points before each reconstruction
  Options options;                 ///< of the reconstruction
};

/// Where points came from and when.
struct Origin {
  std::string frame_id;    ///< of their coordinates
  std::int64_t stamp = 0;  ///< of the newest: nanoseconds
};

/// One reconstruction.
struct Outcome {
  Status status = Status::InternalError;
  std::string message;  ///< one sentence, without a full stop, about a failure
  io::Model mesh;       ///< empty after a failure, and after a reset
  Origin origin;
  std::int64_t points = 0;  ///< that it was made from, before the filters
  double seconds = 0;       ///< wall time, filters included
  Report report;
  std::uint64_t ticket = 0;  ///< the newest request that it answers; 0: a reset
};

/// How it goes.
struct Facts {
  std::int64_t frames = 0;      ///< that came since the start
  std::int64_t superseded = 0;  ///< requests that were never begun, as newer data came: it falls behind
  std::int64_t held = 0;        ///< points
  std::int64_t given_up = 0;    ///< points forgotten because there were too many
  std::int64_t meshes = 0;      ///< published
  bool busy = false;
};

/// Accumulates frames and reconstructs in a thread of its own, always with the newest data. No call but
/// wait() takes longer than adding a frame; memory is bounded by Bounds. All calls may come from any thread.
class Mesher {
 public:
  using Clock = std::chrono::steady_clock;
  using Ticket = std::uint64_t;

  /// Told every outcome but those that were cancelled, one at a time, and an empty mesh after a reset. Is not
  /// called any more after the destructor. Must not call the mesher.
  using Publish = std::function<void(const Outcome& outcome)>;

  explicit Mesher(Publish publish);
  ~Mesher();

  /// From now on; a running reconstruction keeps what it began with.
  void set(const Settings& settings);

  /// Adds a frame, and begins a reconstruction if one is due.
  void add(const io::Model& frame, const Origin& origin, Clock::time_point now);

  /// Begins a reconstruction if one is due by time. To be called now and then.
  void tick(Clock::time_point now);

  /// Reconstructs what is held now. 0 if nothing is held.
  Ticket request();

  /// Waits for a reconstruction, or that of newer data in its place; null if it was cancelled by a reset or
  /// by the end.
  std::shared_ptr<const Outcome> wait(Ticket ticket);

  /// Ends what waits in wait() and takes no requests any more: what has to be done before the destructor
  /// where other threads may be waiting.
  void stop() { worker_.stop(); }

  /// Forgets all points and the last mesh, ends a running reconstruction, and publishes an empty mesh.
  void reset();

  /// The last one that went well; null if there is none.
  std::shared_ptr<const Outcome> last_mesh() const;

  /// The last one, however it went; null if there is none.
  std::shared_ptr<const Outcome> last() const;

  Facts facts() const;

 private:
  struct Job {
    io::Model cloud;
    Origin origin;
    filters::FilterOptions filters;
    Options options;
    std::int64_t era = 0;
  };

  Ticket request_locked(bool at_once);
  void work(Job& job, Ticket ticket, const std::atomic<bool>& cancel);

  mutable std::mutex mutex_;  // of what follows
  Settings settings_;
  Accumulator accumulator_;
  Origin origin_;
  std::int64_t frames_ = 0, frames_since_ = 0;
  Clock::time_point last_due_{};

  const Publish publish_;
  std::mutex publish_mutex_;          // held while publishing; taken first
  mutable std::mutex results_mutex_;  // of what follows; taken last
  std::int64_t era_ = 0;              // resets so far: what was begun before one is not published after it
  std::int64_t meshes_ = 0;
  std::shared_ptr<const Outcome> last_, last_mesh_;

  NewestWins<Job> worker_;  // the last member: it uses the others
};

}  // namespace filmsticking::stream
