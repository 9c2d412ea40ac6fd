// SPDX-License-Identifier: GPL-3.0-or-later
// The same bytes with any number of threads, and from several reconstructions at once. .ci/threads runs
// these tests under ThreadSanitizer.
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <thread>

#include "filmsticking/reconstruct.h"
#include "support/clouds.h"

namespace filmsticking {
namespace {

struct Job {
  std::vector<Point> points;
  Options options;
};

Job job(std::vector<Point> points, InitialSurface first = InitialSurface::Carve,
        FieldMethod field = FieldMethod::Sculpt) {
  Job one{std::move(points), {}};
  one.options.initial_surface = first;
  one.options.field = field;
  one.options.max_steps = 8;
  one.options.max_rounds = 1;
  return one;
}

// Points on a half sphere, and a few far from it.
std::vector<Point> half_sphere_and_outliers() {
  std::vector<Point> points;
  for (const Point& p : test::sphere(1200, 4))
    if (p[2] > 0) points.push_back(p);
  for (const double x : {4., 5., 6.}) points.push_back({x, -x, 3 * x});
  return points;
}

// Every way through the core that has loops of several threads.
std::vector<Job> jobs() {
  std::vector<Job> all = {job(test::torus(2500, 1)),
                          job(test::torus(70000, 6)),  // several threads triangulate so many
                          job(test::box(1500, 2, {1, 1, 0.02})),
                          job(half_sphere_and_outliers()),
                          job(test::grid(7)),
                          job(test::torus(600, 3), InitialSurface::Sphere),
                          job(test::sphere(500, 3), InitialSurface::Sphere, FieldMethod::Poisson),
                          job(test::torus(500, 3), InitialSurface::Wrap)};
  all.push_back(job(half_sphere_and_outliers()));
  all.back().options.open_boundary = true;
  for (Job& one : all) one.options.stability = true;
  return all;
}

void expect_same(const Result& one, const Result& other) {
  EXPECT_EQ(one.status, other.status);
  EXPECT_EQ(one.message, other.message);
  EXPECT_EQ(one.vertices, other.vertices);
  EXPECT_EQ(one.triangles, other.triangles);
  EXPECT_EQ(one.gaps, other.gaps);
  EXPECT_EQ(one.stability, other.stability);
  EXPECT_EQ(one.report.outliers, other.report.outliers);
  EXPECT_EQ(one.report.tetrahedra, other.report.tetrahedra);
  EXPECT_EQ(one.report.inserted, other.report.inserted);
  EXPECT_EQ(one.report.genus, other.report.genus);
  ASSERT_EQ(one.report.steps.size(), other.report.steps.size());
  for (std::size_t i = 0; i < one.report.steps.size(); ++i) {
    EXPECT_EQ(one.report.steps[i].attracted, other.report.steps[i].attracted);
    EXPECT_EQ(one.report.steps[i].weighted, other.report.steps[i].weighted);
    EXPECT_EQ(one.report.steps[i].held, other.report.steps[i].held);
  }
}

TEST(Threads, OneTwoAndEightGiveTheSameBytes) {
  // Without this, TBB starts no more threads than the machine has processors.
  const tbb::global_control eight(tbb::global_control::max_allowed_parallelism, 8);
  std::mutex guard;
  std::set<std::thread::id> seen;
  // A busy machine may start them late.
  for (int turn = 0; turn < 100 && seen.size() <= 4; ++turn)
    tbb::task_arena(8).execute([&] {
      tbb::parallel_for(0, 64, [&](int) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        const std::lock_guard<std::mutex> lock(guard);
        seen.insert(std::this_thread::get_id());
      });
    });
  ASSERT_GT(seen.size(), 4u);

  for (Job& one : jobs()) {
    SCOPED_TRACE(one.points.size());
    one.options.threads = 1;
    const Result alone = reconstruct(one.points, one.options);
    ASSERT_EQ(alone.status, Status::Ok) << alone.message;
    for (const int threads : {2, 8}) {
      one.options.threads = threads;
      expect_same(alone, reconstruct(one.points, one.options));
    }
  }
}

TEST(Threads, ReconstructionsAtOnceGiveWhatEachGivesAlone) {
  std::vector<Job> all = jobs();
  all.push_back(all[0]);  // the same points twice
  std::vector<Result> alone, together(all.size());
  for (const Job& one : all) alone.push_back(reconstruct(one.points, one.options));
  for (const std::size_t count : {2, 4}) {
    std::atomic<std::size_t> next{0};
    std::vector<std::thread> threads;
    for (std::size_t k = 0; k < count; ++k)
      threads.emplace_back([&] {
        for (std::size_t i = next++; i < all.size(); i = next++)
          together[i] = reconstruct(all[i].points, all[i].options);
      });
    for (std::thread& thread : threads) thread.join();
    for (std::size_t i = 0; i < all.size(); ++i) {
      SCOPED_TRACE(i);
      expect_same(alone[i], together[i]);
    }
  }
}

TEST(Threads, CancellingOneLeavesTheOthersAlone) {
  const Job one = job(test::torus(3000, 5));
  const Result whole = reconstruct(one.points, one.options);
  ASSERT_EQ(whole.status, Status::Ok);
  std::atomic<bool> cancel{false};
  Result stopped, other;
  std::thread first([&] {
    Execution execution;
    execution.cancel = &cancel;
    // Set by another thread, while this one goes on.
    std::thread hand;
    execution.progress = [&](double, const char*) {
      if (!hand.joinable()) hand = std::thread([&] { cancel = true; });
    };
    stopped = reconstruct(one.points, one.options, execution);
    hand.join();
  });
  std::thread second([&] { other = reconstruct(one.points, one.options); });
  first.join();
  second.join();
  EXPECT_EQ(stopped.triangles.empty(), stopped.status == Status::Cancelled);
  expect_same(whole, other);
}

}  // namespace
}  // namespace filmsticking
