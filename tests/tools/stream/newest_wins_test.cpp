// SPDX-License-Identifier: GPL-3.0-or-later
#include "stream/newest_wins.h"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <thread>
#include <vector>

namespace filmsticking::stream {
namespace {

/// A job that lasts until `go` is ready or it is cancelled.
struct Held {
  int number = 0;
  std::shared_future<void> go;
};

/// Records which jobs ended how, and when a job has begun.
struct Notes {
  std::vector<int> done, cancelled;
  std::promise<void> begun;

  void work(const Held& job, const std::atomic<bool>& cancel) {
    if (job.go.valid()) {
      begun.set_value();
      while (job.go.wait_for(std::chrono::milliseconds(1)) != std::future_status::ready && !cancel)
        std::this_thread::yield();
    }
    (cancel ? cancelled : done).push_back(job.number);
  }
};

TEST(NewestWins, DoesAJob) {
  Notes notes;
  NewestWins<Held> worker([&](Held& job, auto, const auto& cancel) { notes.work(job, cancel); });
  for (const int number : {1, 2, 3}) EXPECT_TRUE(worker.wait(worker.submit({number, {}})));
  EXPECT_EQ(notes.done, (std::vector<int>{1, 2, 3}));
  EXPECT_EQ(worker.superseded(), 0);
}

TEST(NewestWins, OnlyTheNewestWaits) {
  Notes notes;
  std::promise<void> go;
  NewestWins<Held> worker([&](Held& job, auto, const auto& cancel) { notes.work(job, cancel); });
  worker.submit({0, go.get_future().share()});
  notes.begun.get_future().wait();
  std::uint64_t second = 0, last = 0;
  for (int number = 1; number <= 100; ++number) {
    last = worker.submit({number, {}});
    if (number == 2) second = last;
  }
  EXPECT_TRUE(worker.busy());
  go.set_value();
  EXPECT_TRUE(worker.wait(second));  // over when the job that replaced it is
  EXPECT_TRUE(worker.wait(last));
  EXPECT_EQ(notes.done, (std::vector<int>{0, 100}));
  EXPECT_EQ(worker.superseded(), 99);
  EXPECT_FALSE(worker.busy());
}

TEST(NewestWins, AtOnceEndsTheRunningJob) {
  Notes notes;
  std::promise<void> never;
  NewestWins<Held> worker([&](Held& job, auto, const auto& cancel) { notes.work(job, cancel); });
  const auto first = worker.submit({1, never.get_future().share()});
  notes.begun.get_future().wait();
  worker.submit({2, {}}, true);
  EXPECT_TRUE(worker.wait(first));  // for the job that replaced it
  EXPECT_EQ(notes.cancelled, (std::vector<int>{1}));
  EXPECT_EQ(notes.done, (std::vector<int>{2}));
}

TEST(NewestWins, CancelEndsAllAndLaterJobsAreDone) {
  Notes notes;
  std::promise<void> never;
  NewestWins<Held> worker([&](Held& job, auto, const auto& cancel) { notes.work(job, cancel); });
  worker.submit({1, never.get_future().share()});
  notes.begun.get_future().wait();
  const auto waiting = worker.submit({2, {}});
  worker.cancel();
  EXPECT_TRUE(worker.wait(waiting));
  worker.cancel();  // with nothing to do
  EXPECT_TRUE(worker.wait(worker.submit({3, {}})));
  EXPECT_EQ(notes.cancelled, (std::vector<int>{1}));
  EXPECT_EQ(notes.done, (std::vector<int>{3}));
}

TEST(NewestWins, StopEndsAllWaits) {
  Notes notes;
  NewestWins<Held> worker([&](Held& job, auto, const auto& cancel) { notes.work(job, cancel); });
  std::thread waits([&] { EXPECT_FALSE(worker.wait(1)); });  // never submitted
  worker.stop();
  waits.join();
}

TEST(NewestWins, TheDestructorEndsTheRunningJob) {
  Notes notes;
  std::promise<void> never;
  {
    NewestWins<Held> worker([&](Held& job, auto, const auto& cancel) { notes.work(job, cancel); });
    worker.submit({1, never.get_future().share()});
    notes.begun.get_future().wait();
    worker.submit({2, {}});
  }
  EXPECT_EQ(notes.cancelled, (std::vector<int>{1}));
  EXPECT_TRUE(notes.done.empty());
}

}  // namespace
}  // namespace filmsticking::stream
