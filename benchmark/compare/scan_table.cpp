// SPDX-License-Identifier: GPL-3.0-or-later
#include "scan_table.h"

#include <algorithm>

#include "markdown.h"
#include "statistics.h"

namespace filmsticking::bench {
namespace {

using Runs = std::vector<const ScanResult*>;

/// Runs with the same text there, in the order in which these come first.
std::vector<Runs> grouped(const Runs& runs, std::string ScanResult::*by) {
  std::vector<Runs> groups;
  for (const ScanResult* run : runs) {
    const auto group = std::find_if(groups.begin(), groups.end(),
                                    [&](const Runs& known) { return known.front()->*by == run->*by; });
    if (group != groups.end()) {
      group->push_back(run);
    } else {
      groups.push_back({run});
    }
  }
  return groups;
}

std::vector<std::string> cells_of(const Runs& runs) {
  std::vector<double> over_truth, used, front, seconds, cpu;
  std::optional<double> longest;
  for (const ScanResult* run : runs) {
    if (run->over_truth) over_truth.push_back(*run->over_truth);
    if (run->used) used.push_back(*run->used);
    if (run->front) front.push_back(*run->front);
    if (const auto taken = run->row.number("cpu_seconds")) cpu.push_back(*taken);
    if (const auto taken = run->row.number("seconds")) seconds.push_back(*taken);
    longest = std::max(longest, run->longest_edge);
  }
  const auto right =
      std::count_if(runs.begin(), runs.end(), [](const ScanResult* run) { return run->wrong.empty(); });
  return {runs.front()->kind,
          std::to_string(right) + " of " + std::to_string(runs.size()),
          rounded(median(over_truth), 3),
          rounded(longest, 3),
          rounded(median(used), 4),
          rounded(median(front), 3),
          rounded(median(seconds), 3),
          rounded(median(cpu), 3)};
}

}  // namespace

std::string scan_tables(const std::vector<ScanResult>& results) {
  Runs all;
  for (const ScanResult& result : results) all.push_back(&result);
  std::string text;
  for (const Runs& of_method : grouped(all, &ScanResult::method)) {
    std::vector<std::vector<std::string>> rows = {
        {"kind", "right of N", "volume or area over truth (median)", "longest face over the size (worst)",
         "points used (median)", "front (median)", "seconds (median)", "CPU seconds (median)"}};
    std::string faults;
    for (const Runs& of_kind : grouped(of_method, &ScanResult::kind)) {
      rows.push_back(cells_of(of_kind));
      for (const ScanResult* run : of_kind)
        if (!run->wrong.empty())
          faults += "- " + run->kind + ", seed " + std::to_string(run->seed) + ": " + run->wrong + "\n";
    }
    text += "### " + of_method.front()->method + "\n\n" + markdown_table(rows) + "\n";
    if (!faults.empty()) text += "What is wrong:\n\n" + faults + "\n";
  }
  return text;
}

}  // namespace filmsticking::bench
