// SPDX-License-Identifier: GPL-3.0-or-later
#include "live_mesher.h"

#include <utility>

#include "io/cloud.h"

namespace filmsticking::stream {

LiveMesher::LiveMesher(Publish publish)
    : publish_(std::move(publish)), worker_([this](Job& job, Ticket ticket, const std::atomic<bool>& cancel) {
        work(job, ticket, cancel);
      }) {}

void LiveMesher::set(const Settings& settings) {
  const std::lock_guard lock(mutex_);
  settings_ = settings;
  cloud_.set_bounds(settings.bounds);
}

void LiveMesher::add(const Frame& frame, const Origin& origin, Clock::time_point now) {
  const std::lock_guard lock(mutex_);
  cloud_.add(frame);
  origin_ = origin;
  ++frames_;
  if (++frames_since_ == 1 && last_due_ == Clock::time_point{}) last_due_ = now;  // the period begins
  request_if(settings_.every_frames > 0 && frames_since_ >= settings_.every_frames, now);
}

void LiveMesher::tick(Clock::time_point now) {
  const std::lock_guard lock(mutex_);
  const std::chrono::duration<double> waited = now - last_due_;
  request_if(settings_.every_seconds > 0 && frames_since_ > 0 && waited.count() >= settings_.every_seconds,
             now);
}

LiveMesher::Ticket LiveMesher::request() {
  const std::lock_guard lock(mutex_);
  return request_locked();
}

void LiveMesher::request_if(bool due, Clock::time_point now) {
  if (!due) return;
  last_due_ = now;
  request_locked();
}

LiveMesher::Ticket LiveMesher::request_locked() {
  if (cloud_.size() == 0) return 0;
  Job job{{cloud_.cloud(), settings_.filters, settings_.options}, origin_, 0};
  {
    const std::lock_guard lock(results_mutex_);
    job.era = era_;
  }
  frames_since_ = 0;
  return worker_.submit(std::move(job), settings_.cancel_outdated);
}

void LiveMesher::work(Job& job, Ticket ticket, const std::atomic<bool>& cancel) {
  auto outcome = std::make_shared<LiveOutcome>();
  static_cast<Outcome&>(*outcome) = make_mesh(std::move(job.mesh), &cancel);
  outcome->origin = job.origin;
  outcome->ticket = ticket;
  const std::lock_guard publish_lock(publish_mutex_);
  {
    const std::lock_guard lock(results_mutex_);
    if (job.era != era_ || outcome->status == Status::Cancelled) return;
    last_ = outcome;
    if (outcome->status == Status::Ok) {
      last_mesh_ = outcome;
      ++meshes_;
    }
  }
  publish_(*outcome);
}

std::shared_ptr<const LiveOutcome> LiveMesher::wait(Ticket ticket) {
  if (!worker_.wait(ticket)) return nullptr;
  const std::lock_guard lock(results_mutex_);
  return last_ && last_->ticket >= ticket ? last_ : nullptr;
}

void LiveMesher::reset() {
  const std::lock_guard publish_lock(publish_mutex_);
  const std::lock_guard lock(mutex_);
  cloud_.clear();
  frames_since_ = 0;
  last_due_ = {};
  {
    const std::lock_guard results_lock(results_mutex_);
    ++era_;
    last_ = last_mesh_ = nullptr;
  }
  worker_.cancel();
  LiveOutcome empty;
  empty.status = Status::Ok;
  empty.mesh.cloud = io::make_cloud({});
  empty.origin = origin_;
  publish_(empty);
}

std::shared_ptr<const LiveOutcome> LiveMesher::last_mesh() const {
  const std::lock_guard lock(results_mutex_);
  return last_mesh_;
}

std::shared_ptr<const LiveOutcome> LiveMesher::last() const {
  const std::lock_guard lock(results_mutex_);
  return last_;
}

Facts LiveMesher::facts() const {
  const std::lock_guard lock(mutex_);
  Facts facts;
  facts.frames = frames_;
  facts.superseded = worker_.superseded();
  facts.held = static_cast<std::int64_t>(cloud_.size());
  facts.given_up = cloud_.given_up();
  facts.busy = worker_.busy();
  const std::lock_guard results_lock(results_mutex_);
  facts.meshes = meshes_;
  return facts;
}

}  // namespace filmsticking::stream
