// SPDX-License-Identifier: GPL-3.0-or-later
// The contract of pcl::FilmstickingPP: progress and cancelling.
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <thread>
#include <vector>

#include "clouds.h"
#include "surface.h"

namespace filmsticking::test {
namespace {

TEST(FilmstickingPP, ProgressNeverFalls) {
  Class filmsticking;
  filmsticking.setInputCloud(make_sphere<PointXYZ>(300));
  const std::thread::id caller = std::this_thread::get_id();
  std::vector<double> shares;
  filmsticking.setProgressCallback([&](double share, const char* stage) {
    EXPECT_NE(stage, nullptr);
    EXPECT_EQ(std::this_thread::get_id(), caller);
    shares.push_back(share);
  });
  run(filmsticking);
  ASSERT_FALSE(shares.empty());
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_GE(shares.front(), 0);
  EXPECT_LE(shares.back(), 1);
}

TEST(FilmstickingPP, CancelFromTheCallbackStops) {
  Class filmsticking;
  filmsticking.setInputCloud(make_sphere<PointXYZ>(2000));
  filmsticking.setProgressCallback([&](double, const char*) { filmsticking.cancel(); });
  expect_failure(filmsticking, Status::Cancelled);
  filmsticking.setProgressCallback(nullptr);
  EXPECT_EQ(run(filmsticking).points.size(), 2000u);
}

TEST(FilmstickingPP, CancelFromAnotherThreadStops) {
  Class filmsticking;
  filmsticking.setInputCloud(make_sphere<PointXYZ>(2000));
  std::thread canceller;
  filmsticking.setProgressCallback([&](double, const char*) {
    if (canceller.joinable()) return;
    canceller = std::thread([&] { filmsticking.cancel(); });
    canceller.join();
    canceller = std::thread([] {});
  });
  ::testing::internal::CaptureStderr();
  const auto surface = run(filmsticking);
  ::testing::internal::GetCapturedStderr();
  ASSERT_TRUE(canceller.joinable());
  canceller.join();
  EXPECT_EQ(filmsticking.getStatus(), Status::Cancelled);
  EXPECT_TRUE(surface.points.empty());
}

TEST(FilmstickingPP, CancelWithoutARunDoesNothing) {
  Class filmsticking;
  filmsticking.setInputCloud(make_sphere<PointXYZ>(300));
  filmsticking.cancel();
  EXPECT_EQ(run(filmsticking).points.size(), 300u);
}

TEST(FilmstickingPP, AThrowingCallbackCancels) {
  Class filmsticking;
  filmsticking.setInputCloud(make_sphere<PointXYZ>(300));
  filmsticking.setProgressCallback(
      [](double, const char*) { throw std::runtime_error("from the callback"); });
  expect_failure(filmsticking, Status::Cancelled);
}

}  // namespace
}  // namespace filmsticking::test
