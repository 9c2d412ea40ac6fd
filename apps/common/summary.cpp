// SPDX-License-Identifier: GPL-3.0-or-later
#include "summary.h"

#include <sys/resource.h>

#include <algorithm>
#include <cstdio>

namespace filmsticking::app {

std::string mesh_summary(const Report& report, const std::string& file) {
  const auto count = [](std::int64_t n, const char* what) {
    return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
  };
  std::string text = "mesh    " + file + ": " + std::to_string(report.interpolated) + " vertices, " +
                     std::to_string(report.triangles) + " triangles\nclosed  ";
  text += report.closed ? "yes" : "no, " + count(report.boundary_loops, "border");
  text += report.manifold ? ", manifold\n" : ", not manifold\n";
  const auto lids =
      std::count_if(report.holes.begin(), report.holes.end(), [](const Hole& h) { return h.closed; });
  if (lids > 0)
    text += "lids    " + count(lids, "hole") + " of " + std::to_string(report.holes.size()) + " closed\n";
  text += "genus   " + std::to_string(report.genus) + ", " + count(report.components, "component") + "\n";
  char share[40];
  std::snprintf(share, sizeof share, " (%.2f %%)",
                report.sites > 0
                    ? 100.0 * static_cast<double>(report.interpolated) / static_cast<double>(report.sites)
                    : 0.0);
  text += "used    " + std::to_string(report.interpolated) + " of " + count(report.sites, "point") + share;
  if (report.outliers > 0) text += ", " + count(report.outliers, "outlier") + " left out";
  if (!report.warning.empty()) text += "\nnote    " + report.warning;
  return text + "\n";
}

std::string cost_summary(double seconds) {
  char text[100];
  std::snprintf(text, sizeof text, "%.1f s, %.0f MB of memory at most", seconds,
                static_cast<double>(peak_memory_bytes()) / 1e6);
  return text;
}

std::int64_t peak_memory_bytes() {
  struct rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return std::int64_t{usage.ru_maxrss} * 1024;
}

}  // namespace filmsticking::app
