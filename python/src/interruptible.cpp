// SPDX-License-Identifier: GPL-3.0-or-later
#include "interruptible.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace filmsticking::python {
namespace {

// Between two looks for a signal: Ctrl-C seems immediate.
constexpr std::chrono::milliseconds kPatience(50);

using Event = std::pair<double, std::string>;

// What the worker says to the calling thread.
class Mailbox {
 public:
  void put(double share, const char* stage) {
    const std::lock_guard<std::mutex> lock(mutex_);
    events_.emplace_back(share, stage);
    changed_.notify_one();
  }
  void end() {
    const std::lock_guard<std::mutex> lock(mutex_);
    ended_ = true;
    changed_.notify_one();
  }
  // Waits a moment; false: the worker has ended, and these are the last events.
  bool take(std::vector<Event>& events) {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait_for(lock, kPatience, [&] { return ended_ || !events_.empty(); });
    events.clear();
    events.swap(events_);
    return !ended_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Event> events_;
  bool ended_ = false;
};

// Joins at the end of its scope, cancelled if that ends early. Holds the interpreter's lock before and after.
class Worker {
 public:
  template <class Work>
  Worker(std::atomic<bool>& cancel, Work work) : cancel_(cancel), thread_(std::move(work)) {}
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  ~Worker() {
    if (!thread_.joinable()) return;
    cancel_ = true;
    join();
  }
  void join() {
    const py::gil_scoped_release release;
    thread_.join();
  }

 private:
  std::atomic<bool>& cancel_;
  std::thread thread_;
};

}  // namespace

Result interruptible(const std::function<Result(const Execution&)>& work, const py::object& progress) {
  Mailbox mailbox;
  std::atomic<bool> cancel{false};
  Execution execution;
  execution.cancel = &cancel;
  if (!progress.is_none())
    execution.progress = [&](double share, const char* stage) { mailbox.put(share, stage); };

  Result result;
  Worker worker(cancel, [&] {
    result = work(execution);
    mailbox.end();
  });
  std::vector<Event> events;
  for (bool running = true; running;) {
    {
      const py::gil_scoped_release release;
      running = mailbox.take(events);
    }
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    for (const auto& [share, stage] : events) progress(share, stage);
  }
  worker.join();
  return result;
}

}  // namespace filmsticking::python
