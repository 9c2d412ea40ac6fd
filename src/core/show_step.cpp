// SPDX-License-Identifier: GPL-3.0-or-later
#include "show_step.h"

namespace filmsticking {

void show_step(const Surface& surface, const SiteSet& sites, const Monitor& monitor, const Report& report) {
  if (!monitor.execution().on_step) return;
  Mesh mesh;
  for (const Vec3& p : surface.positions) mesh.positions.push_back(sites.to_input(p));
  mesh.triangles.assign(surface.triangles.begin(), surface.triangles.end());
  call_back([&] { monitor.execution().on_step(static_cast<int>(report.steps.size()), mesh); });
}

}  // namespace filmsticking
