// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/monitor.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

namespace filmsticking {
namespace {

TEST(Monitor, TimesEveryStageOnceInOrderOfFirstEntry) {
  Report report;
  const Execution execution;
  {
    Monitor monitor(execution, report);
    for (const char* stage : {"one", "two", "one", "three"}) monitor.enter(stage, 0);
  }
  ASSERT_EQ(report.rooms.size(), 3U);
  EXPECT_EQ(report.rooms[0].room, "one");
  EXPECT_EQ(report.rooms[1].room, "two");
  EXPECT_EQ(report.rooms[2].room, "three");
  for (const RoomSeconds& stage : report.rooms) EXPECT_GE(stage.seconds, 0);
}

TEST(Monitor, ProgressNeverFallsAndStaysAFraction) {
  Report report;
  Execution execution;
  std::vector<std::pair<double, std::string>> reports;
  execution.progress = [&](double share, const char* stage) { reports.emplace_back(share, stage); };
  Monitor monitor(execution, report);
  monitor.enter("one", 0.3);
  monitor.enter("two", 0.1);
  monitor.progress(7);
  ASSERT_EQ(reports.size(), 3U);
  EXPECT_EQ(reports[0], std::pair(0.3, std::string("one")));
  EXPECT_EQ(reports[1], std::pair(0.3, std::string("two")));
  EXPECT_EQ(reports[2], std::pair(1.0, std::string("two")));
}

TEST(Monitor, ThrowsOnceTheCallerWantsToStop) {
  Report report;
  std::atomic<bool> stop{false};
  Execution execution;
  execution.cancel = &stop;
  Monitor monitor(execution, report);
  EXPECT_NO_THROW(monitor.enter("one", 0));
  stop = true;
  EXPECT_THROW(monitor.enter("two", 0), Cancelled);
  EXPECT_THROW(monitor.cancel()(), Cancelled);
}

TEST(Monitor, WhatACallbackThrowsIsNoFailureOfTheLibrary) {
  const auto thrown = [](const auto& throwing) -> std::string {
    try {
      call_back(throwing);
    } catch (const CallbackThrew& threw) {
      return threw.what;
    }
    return "nothing";
  };
  EXPECT_EQ(thrown([] { throw std::runtime_error("no paper"); }), "no paper");
  EXPECT_EQ(thrown([] { throw 7; }), "an exception of unknown type");
  EXPECT_EQ(thrown([] {}), "nothing");
  EXPECT_THROW(call_back([] { throw std::bad_alloc(); }), std::bad_alloc);
}

}  // namespace
}  // namespace filmsticking
