// SPDX-License-Identifier: GPL-3.0-or-later
// reconstruct() when memory or time are short, or the caller cancels.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <new>
#include <stdexcept>
#include <utility>

#include "filmsticking/reconstruct.h"
#include "support/clouds.h"

namespace {
// The allocation that fails, counted down; below 0 none does.
std::atomic<std::int64_t> until_failure{-1}, allocations{0};
// The allocation at which `cancel` is set.
std::atomic<std::int64_t> cancel_at{-1};
std::atomic<bool> cancel{false};
std::clock_t cancelled_at = 0;  // processor time, which other programs do not take

void* allocate(std::size_t size, std::size_t alignment) {
  if (++allocations == cancel_at) {
    cancelled_at = std::clock();
    cancel = true;
  }
  if (until_failure >= 0 && until_failure-- == 0) return nullptr;
  return alignment <= alignof(std::max_align_t)
             ? std::malloc(size > 0 ? size : 1)
             : std::aligned_alloc(alignment, (size + alignment) / alignment * alignment);
}
void* allocate_or_throw(std::size_t size, std::size_t alignment) {
  void* memory = allocate(size, alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
// Not inlined, where GCC would take new for one allocator and free() for another's end.
[[gnu::noinline]] void release(void* memory) noexcept { std::free(memory); }
}  // namespace

void* operator new(std::size_t size) { return allocate_or_throw(size, 1); }
void* operator new[](std::size_t size) { return allocate_or_throw(size, 1); }
void* operator new(std::size_t size, std::align_val_t to) {
  return allocate_or_throw(size, static_cast<std::size_t>(to));
}
void* operator new[](std::size_t size, std::align_val_t to) {
  return allocate_or_throw(size, static_cast<std::size_t>(to));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return allocate(size, 1); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return allocate(size, 1); }
void operator delete(void* memory) noexcept { release(memory); }
void operator delete[](void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete[](void* memory, std::size_t) noexcept { release(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { release(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { release(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { release(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { release(memory); }

namespace filmsticking {
namespace {

// Every point of one line is a Delaunay neighbour of every point of the other.
std::vector<Point> skew_lines(int n) {
  test::Random random(1);
  std::vector<Point> points;
  for (int i = 0; i < n; ++i) {
    const double x = random.uniform(-1, 1);
    points.push_back(i % 2 ? Point{x, -0.5, 0} : Point{0, 0.5, x});
  }
  return points;
}

void expect_empty(const Result& result, Status status) {
  EXPECT_EQ(result.status, status) << result.message;
  EXPECT_FALSE(result.message.empty());
  EXPECT_TRUE(result.vertices.empty() && result.triangles.empty() && result.gaps.empty() &&
              result.stability.empty());
}

TEST(Limits, AQuadraticTriangulationIsRefused) {
  for (const int n : {10000, 30000}) expect_empty(reconstruct(skew_lines(n)), Status::TooComplex);
  const Result small = reconstruct(skew_lines(400));
  EXPECT_GT(small.report.tetrahedra, 30000);  // quadratic as well, but there are few
  EXPECT_NE(small.status, Status::TooComplex);
}

std::vector<Point> line_and_circle(int n) {
  test::Random random(1);
  std::vector<Point> points;
  for (int i = 0; i < n; ++i) {
    const double x = random.uniform(-1, 1), turn = M_PI * random.uniform(-1, 1);
    points.push_back(i % 2 ? Point{0, 0, x} : Point{std::cos(turn), std::sin(turn), 0});
  }
  return points;
}

// A ring of points, all of which are neighbours of an apex far above it.
std::vector<Point> cone(int n) {
  test::Random random(2);
  std::vector<Point> points{{0, 0, 3}};
  while (static_cast<int>(points.size()) < n) {
    const double turn = M_PI * random.uniform(-1, 1);
    points.push_back({std::cos(turn), std::sin(turn), 0.001 * random.uniform(-1, 1)});
  }
  return points;
}

// Half a sphere around a point that all others are neighbours of.
std::vector<Point> star(int n) {
  std::vector<Point> points = test::sphere(n, 3);
  for (Point& p : points) p[2] = std::abs(p[2]);
  points[0] = {0, 0, 0};
  return points;
}

// With eight times as many tetrahedra their square would take 64 times as long; their number times its
// logarithm takes ten times, and twice that where one of the clouds gives more trouble than the other. By the
// processor's time, which other programs hardly change.
TEST(Limits, TimeFollowsTheTetrahedra) {
  struct Case {
    const char* name;
    std::vector<Point> (*points)(int);
    int few, many;
  };
  for (const Case& c :
       {Case{"two lines", skew_lines, 350, 1000}, Case{"line and circle", line_and_circle, 350, 1000},
        Case{"cone", cone, 4000, 32000}, Case{"star", star, 4000, 32000}}) {
    Options options;
    options.threads = 1;
    double seconds[2];
    std::int64_t tetrahedra[2];
    for (const bool many : {false, true}) {
      const auto points = c.points(many ? c.many : c.few);
      const std::clock_t start = std::clock();
      const Result result = reconstruct(points, options);
      seconds[many] = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
      tetrahedra[many] = result.report.tetrahedra;
      // Hardly a point of two curves is on one surface.
      EXPECT_TRUE(result.status == Status::Ok || result.status == Status::NoSurface)
          << c.name << ": " << result.message;
      // Such a film is a way out: virtual sites would take the square.
      if (result.report.tetrahedra < 64 * result.report.sites) continue;
      for (const StepRecord& step : result.report.steps) EXPECT_EQ(step.virtual_left, 0) << c.name;
    }
    EXPECT_NEAR(static_cast<double>(tetrahedra[1]) / static_cast<double>(tetrahedra[0]), 8, 0.5) << c.name;
    EXPECT_LT(seconds[1], 32 * seconds[0])
        << c.name << ": " << seconds[0] << " s, then " << seconds[1] << " s";
  }
}

TEST(Limits, SurfacesAreFarFromTheBound) {
  std::vector<Point> tower = test::torus(3000, 1, 1, 0.01);
  test::Random random(2);
  for (int i = 0; i < 3000; ++i) {
    const double turn = random.uniform(0, 2 * M_PI);
    tower.push_back({std::cos(turn), std::sin(turn), random.uniform(2, 10)});
  }
  for (const auto& points :
       {test::sphere(8000, 1), test::torus(8000, 1), test::box(8000, 1, {1, 1, 0.01}), tower}) {
    const Result result = reconstruct(points);
    EXPECT_EQ(result.status, Status::Ok);
    EXPECT_LT(result.report.tetrahedra, 21 * result.report.sites);
  }
}

TEST(Limits, TooLittleMemoryIsReportedBeforeItIsTaken) {
  const auto points = test::torus(5000, 1);
  Options options;
  for (const std::int64_t bytes : {std::int64_t{1}, std::int64_t{400000}, std::int64_t{4000000}}) {
    options.max_memory = bytes;
    const Result result = reconstruct(points, options);
    expect_empty(result, Status::OutOfMemory);
    EXPECT_NE(result.message.find("would be needed"), std::string::npos);
  }
  options.max_memory = 40000000;
  EXPECT_EQ(reconstruct(points, options).status, Status::Ok);
  EXPECT_EQ(reconstruct(skew_lines(4000), options).status, Status::OutOfMemory);  // seen while it grows
  options.max_memory = -1;
  expect_empty(reconstruct(points, options), Status::InvalidOptions);
}

TEST(Limits, CancelIsHeardAtAnyMoment) {
  Options film;
  film.method = Method::Film;
  for (const auto& [points, options] :
       {std::pair(test::torus(20000, 1), Options{}), std::pair(test::torus(2000, 1), film)}) {
    Options alone = options;
    alone.threads = 1;
    const std::int64_t before = allocations;
    const std::clock_t start = std::clock();
    const Result whole = reconstruct(points, alone);
    const std::clock_t time = std::clock() - start;
    ASSERT_EQ(whole.status, Status::Ok);
    const std::int64_t count = allocations - before;
    Execution execution;
    execution.cancel = &cancel;
    constexpr std::int64_t kMoments = 40;
    for (std::int64_t i = 0; i < kMoments; ++i) {
      cancel_at = allocations + 1 + i * count / kMoments;
      const Result result = reconstruct(points, alone, execution);
      const std::clock_t after = std::clock() - cancelled_at;
      cancel_at = -1;
      cancel = false;
      expect_empty(result, Status::Cancelled);
      EXPECT_LT(after, time / 4) << i;
    }
    EXPECT_EQ(reconstruct(points, alone).triangles, whole.triangles);
  }
}

TEST(Limits, WhatACallbackThrowsEndsIt) {
  const auto points = test::torus(1000, 1);
  for (int moment = 0; moment < 6; ++moment) {
    Execution execution;
    int calls = 0;
    execution.progress = [&](double, const char*) {
      if (calls++ == moment) throw std::runtime_error("the caller's reason");
    };
    const Result result = reconstruct(points, {}, execution);
    expect_empty(result, Status::Cancelled);
    EXPECT_EQ(result.message, "the caller's reason");
  }
  Execution execution;
  execution.on_step = [](int, const Mesh&) { throw 1; };
  expect_empty(reconstruct(points, {}, execution), Status::Cancelled);
  execution.on_step = [](int, const Mesh&) { throw std::bad_alloc(); };
  expect_empty(reconstruct(points, {}, execution), Status::OutOfMemory);
}

// Fails the k-th allocation for every k of a small reconstruction, and every `stride`th of a larger one.
void sweep(const std::vector<Point>& points, Options options, std::int64_t stride) {
  options.threads = 1;
  const std::int64_t before = allocations;
  const Result whole = reconstruct(points, options);
  const std::int64_t count = allocations - before;
  ASSERT_EQ(whole.status, Status::Ok);
  ASSERT_GT(count, 10 * stride);
  std::int64_t failed = 0;
  for (std::int64_t k = 0; k < count; k += stride) {
    until_failure = k;
    const Result result = reconstruct(points, options);
    until_failure = -1;
    if (result.status == Status::Ok) {  // something did without the memory
      ASSERT_EQ(result.triangles, whole.triangles) << k;
      continue;
    }
    ++failed;
    ASSERT_EQ(result.status, Status::OutOfMemory) << k << ": " << result.message;
    ASSERT_TRUE(result.vertices.empty() && result.triangles.empty()) << k;
  }
  EXPECT_GT(failed, count / stride / 2);
  const Result again = reconstruct(points, options);
  EXPECT_EQ(again.vertices, whole.vertices);
  EXPECT_EQ(again.triangles, whole.triangles);
}

TEST(Limits, AnyAllocationMayFail) {
  sweep(test::sphere(30, 1), {}, 1);
  sweep(test::torus(1500, 1), {}, 97);
  Options film;
  film.method = Method::Film;
  film.max_steps = 6;
  film.max_rounds = 1;
  sweep(test::sphere(60, 1), film, 53);
}

}  // namespace
}  // namespace filmsticking
