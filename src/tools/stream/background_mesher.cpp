// SPDX-License-Identifier: GPL-3.0-or-later
#include "background_mesher.h"

namespace filmsticking::capture {

BackgroundMesher::BackgroundMesher(const Options& options, Listener listener)
    : options_(options), listener_(std::move(listener)), thread_([this] { work(); }) {}

BackgroundMesher::~BackgroundMesher() {
  cancel_ = true;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    end_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

bool BackgroundMesher::idle() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return !job_;
}

bool BackgroundMesher::offer(std::size_t frames, io::Model cloud) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (job_) return false;
    job_ = Job{frames, std::move(cloud)};
  }
  changed_.notify_all();
  return true;
}

void BackgroundMesher::wait() {
  std::unique_lock<std::mutex> lock(mutex_);
  changed_.wait(lock, [this] { return !job_; });
}

void BackgroundMesher::work() {
  std::unique_lock<std::mutex> lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return end_ || job_; });
    if (end_) return;
    lock.unlock();  // nobody else touches the job while it is there
    Execution execution;
    execution.progress = listener_.progress;
    execution.cancel = &cancel_;
    const Result result = reconstruct(job_->cloud.positions, options_, execution);
    if (!cancel_) listener_.done(job_->frames, job_->cloud, result);
    lock.lock();
    job_.reset();
    changed_.notify_all();
  }
}

}  // namespace filmsticking::capture
