// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <thread>
#include <vector>

namespace filmsticking::test {
namespace {

using Clock = std::chrono::steady_clock;

thread_local std::uint64_t at_work = 0;
const char* sweep_name = "";

/// Only what a signal handler may call. A crash in a thread of the library's own names the i of no worker: 0.
void print_crash(int signal) {
  char text[128];
  const int length = std::snprintf(text, sizeof text, "%s %llu: signal %d\n", sweep_name,
                                   static_cast<unsigned long long>(at_work), signal);
  const ssize_t ignored = write(STDERR_FILENO, text, static_cast<std::size_t>(length));
  (void)ignored;
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

struct Worker {
  std::atomic<std::uint64_t> now{0};
  std::atomic<Clock::rep> since{0};  // 0: at rest
};

}  // namespace

int sweep(const std::string& name, std::uint64_t first, std::uint64_t last, int patience, int most,
          const std::function<std::string(std::uint64_t)>& fault) {
  sweep_name = name.c_str();
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL}) std::signal(signal, print_crash);
  const auto begin = Clock::now();
  std::atomic<std::uint64_t> next{first};
  std::atomic<int> faults{0}, working{0};
  std::mutex reporting;  // guards the next two, and the output
  Clock::duration longest{0};
  std::uint64_t slowest = first;
  std::vector<Worker> workers(std::max(1u, std::thread::hardware_concurrency()));
  std::vector<std::thread> threads;
  working = static_cast<int>(workers.size());
  for (Worker& worker : workers)
    threads.emplace_back([&] {
      for (std::uint64_t i = next++; i < last && faults < most; i = next++) {
        at_work = i;
        worker.now = i;
        worker.since = Clock::now().time_since_epoch().count();
        const std::string wrong = fault(i);
        const auto took = Clock::now().time_since_epoch() - Clock::duration(worker.since.exchange(0));
        const std::lock_guard<std::mutex> lock(reporting);
        if (took > longest) longest = took, slowest = i;
        if (wrong.empty()) continue;
        ++faults;
        std::printf("%s %llu: %s\n", name.c_str(), static_cast<unsigned long long>(i), wrong.c_str());
        std::fflush(stdout);
      }
      --working;
    });
  while (working > 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    for (const Worker& worker : workers) {
      const Clock::rep since = worker.since;
      if (since == 0 ||
          Clock::now().time_since_epoch() - Clock::duration(since) < std::chrono::seconds(patience))
        continue;
      std::fprintf(stderr, "%s %llu: no end after %d s\n", name.c_str(),
                   static_cast<unsigned long long>(worker.now), patience);
      std::_Exit(3);
    }
  }
  for (std::thread& thread : threads) thread.join();
  const std::uint64_t done = std::min(next.load(), last) - first;
  const auto seconds = [](Clock::duration time) { return std::chrono::duration<double>(time).count(); };
  std::printf("%s: %llu tried, %d faults, %.1f s; the slowest was %llu, %.1f s\n", name.c_str(),
              static_cast<unsigned long long>(done), faults.load(), seconds(Clock::now() - begin),
              static_cast<unsigned long long>(slowest), seconds(longest));
  return faults;
}

}  // namespace filmsticking::test
