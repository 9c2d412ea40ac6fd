// SPDX-License-Identifier: GPL-3.0-or-later
#include "summary.h"

#include <sys/resource.h>

#include <cinttypes>
#include <cstdio>

namespace filmsticking::app {

std::string mesh_summary(const Result& result, const std::string& file) {
  const Report& report = result.report;
  const double share =
      report.sites > 0 ? 100.0 * static_cast<double>(report.interpolated) / static_cast<double>(report.sites)
                       : 0;
  char text[400];
  std::snprintf(text, sizeof text,
                ": %zu vertices, %zu triangles\n"
                "closed  %s, %s\n"
                "genus   %" PRId64 ", %" PRId64
                " component%s\n"
                "used    %" PRId64 " of %" PRId64 " points (%.2f %%)\n",
                result.vertices.size(), result.triangles.size(), report.closed ? "yes" : "no",
                report.manifold ? "manifold" : "not manifold", report.genus, report.components,
                report.components == 1 ? "" : "s", report.interpolated, report.sites, share);
  return "mesh    " + file + text;
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
