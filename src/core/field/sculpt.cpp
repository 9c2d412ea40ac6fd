// SPDX-License-Identifier: GPL-3.0-or-later
#include "sculpt.h"

#include <algorithm>
#include <cmath>

#include "minimum_cut.h"
#include "parallel.h"

namespace filmsticking {
namespace {

// Both capacities of a facet together must fit 32 bits; it is that of 60,000 mean facets.
constexpr std::int64_t kMostCapacity = 1000000000;

}  // namespace

std::vector<char> sculpt(const TetrahedralMesh& mesh, const FacetEvidence& evidence,
                         const std::vector<double>& hold, bool open, const Cancel& cancel) {
  CutGraph graph{mesh.mirror, {}, {}};
  graph.capacity.resize(mesh.size());
  graph.terminal.resize(mesh.size());
  const double sum = parallel_sum(mesh.size(), [&](std::size_t t) {
    const auto& c = evidence.cost[t];
    return double{c[0]} + c[1] + c[2] + c[3];
  });
  // Whole numbers, so that the flow is exact and ends: a mean facet costs some thousands.
  const double unit = sum > 0 ? 4096.0 * 4.0 * static_cast<double>(mesh.size()) / sum : 1;
  auto price = [&](double cost) {
    return static_cast<std::int64_t>(std::llround(std::min(cost * unit, 1e12)));
  };
  std::vector<char> fallback(mesh.size());
  parallel_each(mesh.size(), [&](std::size_t t) {
    const bool infinite = !open && mesh.tets.infinite(static_cast<Index>(t));
    for (int k = 0; k < 4; ++k)
      graph.capacity[t][k] =
          static_cast<std::int32_t>(std::min<std::int64_t>(price(evidence.cost[t][k]), kMostCapacity));
    const std::int64_t held = price(std::abs(hold[t]));
    graph.terminal[t] = infinite ? -(std::int64_t(1) << 50) : hold[t] > 0 ? held : -held;
    fallback[t] = !infinite && hold[t] > 0;
  });
  std::vector<char> inside = minimum_cut(graph, fallback, cancel);
  for (std::size_t t = 0; t < mesh.size(); ++t)
    if (!open && mesh.tets.infinite(static_cast<Index>(t))) inside[t] = 0;
  return inside;
}

}  // namespace filmsticking
