// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes from a stream of frames: what a node does, without the middleware.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "frame.h"
#include "make_mesh.h"
#include "newest_cloud.h"
#include "newest_wins.h"

namespace filmsticking::stream {

/// Everything that can be chosen, at any time.
struct Settings {
  Bounds bounds;                   ///< of what is held
  int every_frames = 1;            ///< reconstruct after this many frames; 0: not by their number
  double every_seconds = 0;        ///< reconstruct after this time if frames came; 0: not by time
  bool cancel_outdated = false;    ///< end a running reconstruction when newer data is due
  filters::FilterOptions filters;  ///< run on all points before each reconstruction
  Options options;                 ///< of the reconstruction; each point was seen from its frame's sensor
};

/// Where and when points were measured.
struct Origin {
  std::string frame_id;    ///< the coordinate system of the points
  std::int64_t stamp = 0;  ///< of the newest: nanoseconds
};

/// One reconstruction of a stream.
struct LiveOutcome : Outcome {
  Origin origin;
  std::uint64_t ticket = 0;  ///< the newest request that it answers; 0: a reset
};

/// Counts since the start, and the state.
struct Facts {
  std::int64_t frames = 0;      ///< that came
  std::int64_t superseded = 0;  ///< requests that newer data replaced before they began: it falls behind
  std::int64_t held = 0;        ///< points
  std::int64_t given_up = 0;    ///< points forgotten because there were too many
  std::int64_t meshes = 0;      ///< published
  bool busy = false;
};

/// Fuses frames and reconstructs in a thread of its own, always from the newest data. No call but wait()
/// takes longer than adding a frame; Bounds bounds the memory. All calls may come from any thread.
class LiveMesher {
 public:
  using Clock = std::chrono::steady_clock;
  using Ticket = std::uint64_t;

  /// Receives every outcome that was not cancelled, one at a time, and an empty mesh after a reset. Is not
  /// called after the destructor. Must not call the mesher.
  using Publish = std::function<void(const LiveOutcome& outcome)>;

  explicit LiveMesher(Publish publish);

  /// From now on; a running reconstruction keeps the settings that it began with.
  void set(const Settings& settings);

  /// Adds a frame, and begins a reconstruction if one is due. Throws as NewestCloud::add() does.
  void add(const Frame& frame, const Origin& origin, Clock::time_point now);

  /// Begins a reconstruction if one is due by time. To be called now and then.
  void tick(Clock::time_point now);

  /// Reconstructs what is held now. 0 if nothing is held.
  Ticket request();

  /// Waits for a reconstruction, or that of newer data in its place; null if it was cancelled by a reset or
  /// by stop().
  std::shared_ptr<const LiveOutcome> wait(Ticket ticket);

  /// Ends all wait()s and takes no more requests: to be called before the destructor if other threads may be
  /// waiting.
  void stop() { worker_.stop(); }

  /// Forgets all points and the last mesh, ends a running reconstruction, and publishes an empty mesh.
  void reset();

  /// The last outcome with a mesh; null if there is none.
  std::shared_ptr<const LiveOutcome> last_mesh() const;

  /// The last outcome; null if there is none.
  std::shared_ptr<const LiveOutcome> last() const;

  Facts facts() const;

 private:
  struct Job {
    MeshJob mesh;
    Origin origin;
    std::int64_t era = 0;
  };

  void request_if(bool due, Clock::time_point now);
  Ticket request_locked();
  void work(Job& job, Ticket ticket, const std::atomic<bool>& cancel);

  mutable std::mutex mutex_;  // of what follows
  Settings settings_;
  NewestCloud cloud_;
  Origin origin_;
  std::int64_t frames_ = 0, frames_since_ = 0;
  Clock::time_point last_due_{};

  const Publish publish_;
  std::mutex publish_mutex_;          // held while publishing; taken first
  mutable std::mutex results_mutex_;  // of what follows; taken last
  std::int64_t era_ = 0;              // resets so far: what began before one is not published after it
  std::int64_t meshes_ = 0;
  std::shared_ptr<const LiveOutcome> last_, last_mesh_;

  NewestWins<Job> worker_;  // the last member: it uses the others
};

}  // namespace filmsticking::stream
