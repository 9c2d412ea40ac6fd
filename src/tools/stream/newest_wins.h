// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace filmsticking::stream {

/// A thread that runs one job at a time. While it is busy one job waits, the newest: it replaces an older
/// one. So no queue grows, and no caller waits to hand a job in. A caller that does not want a job to wait
/// looks at busy() first.
template <class Job>
class NewestWins {
 public:
  /// Numbers jobs in the order in which they came, from 1.
  using Ticket = std::uint64_t;

  /// Runs a job; should return soon once `cancel` is true. Must not throw.
  using Work = std::function<void(Job& job, Ticket ticket, const std::atomic<bool>& cancel)>;

  explicit NewestWins(Work work) : work_(std::move(work)), thread_([this] { run(); }) {}

  NewestWins(const NewestWins&) = delete;
  NewestWins& operator=(const NewestWins&) = delete;

  /// Ends the running job and forgets the waiting one.
  ~NewestWins() {
    stop();
    thread_.join();
  }

  /// Hands a job in; `at_once` ends the running one for it.
  Ticket submit(Job job, bool at_once = false) {
    const std::lock_guard lock(mutex_);
    if (waiting_) ++superseded_;
    waiting_ = std::move(job);
    if (at_once) cancel_ = true;
    changed_.notify_all();
    return ++newest_;
  }

  /// Ends the running job and forgets the waiting one; runs jobs that come later.
  void cancel() {
    const std::lock_guard lock(mutex_);
    waiting_.reset();
    cancel_ = true;
    if (!running_) over_ = newest_;
    changed_.notify_all();
  }

  /// Waits until that job, or a newer one in its place, is over; false if the thread ends before.
  bool wait(Ticket ticket) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return stop_ || over_ >= ticket; });
    return over_ >= ticket;
  }

  /// Cancels, and runs no later job. Call it before what the work uses is destroyed.
  void stop() {
    const std::lock_guard lock(mutex_);
    stop_ = true;
    waiting_.reset();
    cancel_ = true;
    changed_.notify_all();
  }

  /// Whether a job runs or waits.
  bool busy() const {
    const std::lock_guard lock(mutex_);
    return running_ || waiting_;
  }

  /// How many jobs never ran because a newer one replaced them.
  std::int64_t superseded() const {
    const std::lock_guard lock(mutex_);
    return superseded_;
  }

 private:
  void run() {
    std::unique_lock lock(mutex_);
    for (;;) {
      changed_.wait(lock, [this] { return stop_ || waiting_; });
      if (stop_) return;
      Job job = std::move(*waiting_);
      waiting_.reset();
      const Ticket ticket = newest_;
      cancel_ = false;
      running_ = true;
      lock.unlock();
      work_(job, ticket, cancel_);
      lock.lock();
      running_ = false;
      if (!waiting_)
        over_ = newest_;  // younger jobs were cancelled, if there are any
      else if (!cancel_)
        over_ = ticket;  // else the waiting job replaces it
      changed_.notify_all();
    }
  }

  const Work work_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Job> waiting_;
  std::atomic<bool> cancel_{false};
  bool running_ = false;
  bool stop_ = false;
  Ticket newest_ = 0;  // handed in
  Ticket over_ = 0;    // done or cancelled, as all before it
  std::int64_t superseded_ = 0;
  std::thread thread_;  // the last member: it uses the others
};

}  // namespace filmsticking::stream
