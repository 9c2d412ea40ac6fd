// SPDX-License-Identifier: GPL-3.0-or-later
// The time of the core's rooms, each alone, on points of a generated surface.
#include <benchmark/benchmark.h>

#include "power_diagram.h"
#include "site_set.h"
#include "support/clouds.h"

namespace filmsticking {
namespace {

void delaunay_triangulation(benchmark::State& state) {
  const SiteSet sites = make_site_set(test::torus(static_cast<int>(state.range(0)), 1));
  for (auto _ : state) {
    const DelaunayTriangulation triangulation(sites.perturbed);
    benchmark::DoNotOptimize(triangulation.dimension());
  }
}
BENCHMARK(delaunay_triangulation)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace filmsticking
