// SPDX-License-Identifier: GPL-3.0-or-later
#include "live_mesher.h"

#include <exception>
#include <new>
#include <utility>

#include "common/mesh_model.h"
#include "filmsticking/reconstruct.h"
#include "filters/model_filter.h"

namespace filmsticking::stream {
namespace {

/// Filters and reconstructs; nothing is thrown.
Outcome reconstruct_cloud(io::Model cloud, const filters::FilterOptions& filters, const Options& options,
                          const std::atomic<bool>& cancel) noexcept {
  Outcome outcome;
  const auto begin = Mesher::Clock::now();
  try {
    outcome.points = static_cast<std::int64_t>(cloud.positions.size());
    if (filters.any()) cloud = filters::filter(cloud, filters);
    Execution execution;
    execution.cancel = &cancel;
    Options from_there = options;
    from_there.viewpoint = cloud.viewpoint;
    Result result = reconstruct(cloud.positions, from_there, execution);
    outcome.status = result.status;
    if (result.status == Status::Ok)
      outcome.mesh = app::mesh_model(std::move(cloud), result);
    else
      outcome.message = app::reason(result);
    outcome.report = std::move(result.report);
  } catch (const std::bad_alloc&) {
    outcome.status = Status::OutOfMemory;
    outcome.message = describe(outcome.status);
    outcome.mesh = {};
  } catch (const filters::FilterError& error) {
    outcome.status = Status::InvalidOptions;
    outcome.message = error.what();
  } catch (const std::exception& error) {
    outcome.status = Status::InternalError;
    outcome.message = error.what();
  }
  outcome.seconds = std::chrono::duration<double>(Mesher::Clock::now() - begin).count();
  return outcome;
}

}  // namespace

Mesher::Mesher(Publish publish)
    : publish_(std::move(publish)), worker_([this](Job& job, Ticket ticket, const std::atomic<bool>& cancel) {
        work(job, ticket, cancel);
      }) {}

Mesher::~Mesher() = default;

void Mesher::set(const Settings& settings) {
  const std::lock_guard lock(mutex_);
  settings_ = settings;
  accumulator_.set_bounds(settings.bounds);
}

void Mesher::add(const io::Model& frame, const Origin& origin, Clock::time_point now) {
  const std::lock_guard lock(mutex_);
  accumulator_.add(frame);
  origin_ = origin;
  ++frames_;
  if (++frames_since_ == 1 && last_due_ == Clock::time_point{}) last_due_ = now;  // the period begins
  if (settings_.every_frames > 0 && frames_since_ >= settings_.every_frames) {
    last_due_ = now;
    request_locked(settings_.cancel_outdated);
  }
}

void Mesher::tick(Clock::time_point now) {
  const std::lock_guard lock(mutex_);
  if (!(settings_.every_seconds > 0) || frames_since_ == 0) return;
  if (std::chrono::duration<double>(now - last_due_).count() < settings_.every_seconds) return;
  last_due_ = now;
  request_locked(settings_.cancel_outdated);
}

Mesher::Ticket Mesher::request() {
  const std::lock_guard lock(mutex_);
  return request_locked(settings_.cancel_outdated);
}

Mesher::Ticket Mesher::request_locked(bool at_once) {
  if (accumulator_.size() == 0) return 0;
  Job job{accumulator_.cloud(), origin_, settings_.filters, settings_.options, 0};
  {
    const std::lock_guard lock(results_mutex_);
    job.era = era_;
  }
  frames_since_ = 0;
  return worker_.submit(std::move(job), at_once);
}

void Mesher::work(Job& job, Ticket ticket, const std::atomic<bool>& cancel) {
  auto outcome =
      std::make_shared<Outcome>(reconstruct_cloud(std::move(job.cloud), job.filters, job.options, cancel));
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

std::shared_ptr<const Outcome> Mesher::wait(Ticket ticket) {
  if (!worker_.wait(ticket)) return nullptr;
  const std::lock_guard lock(results_mutex_);
  return last_ && last_->ticket >= ticket ? last_ : nullptr;
}

void Mesher::reset() {
  const std::lock_guard publish_lock(publish_mutex_);
  const std::lock_guard lock(mutex_);
  accumulator_.clear();
  frames_since_ = 0;
  last_due_ = {};
  {
    const std::lock_guard results_lock(results_mutex_);
    ++era_;
    last_ = last_mesh_ = nullptr;
  }
  worker_.cancel();
  Outcome empty;
  empty.status = Status::Ok;
  empty.origin = origin_;
  publish_(empty);
}

std::shared_ptr<const Outcome> Mesher::last_mesh() const {
  const std::lock_guard lock(results_mutex_);
  return last_mesh_;
}

std::shared_ptr<const Outcome> Mesher::last() const {
  const std::lock_guard lock(results_mutex_);
  return last_;
}

Facts Mesher::facts() const {
  const std::lock_guard lock(mutex_);
  Facts facts;
  facts.frames = frames_;
  facts.superseded = worker_.superseded();
  facts.held = static_cast<std::int64_t>(accumulator_.size());
  facts.given_up = accumulator_.given_up();
  facts.busy = worker_.busy();
  const std::lock_guard results_lock(results_mutex_);
  facts.meshes = meshes_;
  return facts;
}

}  // namespace filmsticking::stream
