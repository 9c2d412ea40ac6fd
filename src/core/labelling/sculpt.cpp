// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/sculpt.h"

#include <algorithm>
#include <cmath>

#include "geometry/parallel.h"

namespace filmsticking {
namespace {

// Both capacities of a facet together must fit 32 bits. It is the cost of 60,000 mean facets.
constexpr std::int64_t kMostCapacity = 1000000000;

}  // namespace

Sculptor::Sculptor(const TetrahedralMesh& mesh, const FacetEvidence& evidence,
                   const std::vector<double>& hold, bool open)
    : mesh_(mesh), open_(open), graph_{mesh.mirror, {}, {}}, fallback_(mesh.size()) {
  graph_.capacity.resize(mesh.size());
  graph_.terminal.resize(mesh.size());
  const double sum = parallel_sum(mesh.size(), [&](std::size_t t) {
    const auto& c = evidence.cost[t];
    return double{c[0]} + c[1] + c[2] + c[3];
  });
  // Whole numbers, so that the flow is exact and ends: a mean facet costs some thousands.
  if (sum > 0) unit_ = 4096.0 * 4.0 * static_cast<double>(mesh.size()) / sum;
  parallel_each(mesh.size(), [&](std::size_t t) {
    const bool infinite = !open && mesh.tets.infinite(static_cast<Index>(t));
    for (int k = 0; k < 4; ++k)
      graph_.capacity[t][k] =
          static_cast<std::int32_t>(std::min<std::int64_t>(price(evidence.cost[t][k]), kMostCapacity));
    const std::int64_t held = price(std::abs(hold[t]));
    graph_.terminal[t] = infinite ? -(std::int64_t(1) << 50) : hold[t] > 0 ? held : -held;
    fallback_[t] = !infinite && hold[t] > 0;
  });
}

std::int64_t Sculptor::price(double cost) const {
  return static_cast<std::int64_t>(std::llround(std::min(cost * unit_, 1e12)));
}

std::vector<char> Sculptor::cut(const Cancel& cancel) {
  std::vector<char> inside = minimum_cut(graph_, fallback_, cancel);
  parallel_each(mesh_.size(), [&](std::size_t t) {
    if (!open_ && mesh_.tets.infinite(static_cast<Index>(t))) inside[t] = 0;
  });
  return inside;
}

// The rest of the larger graph is the rest of the smaller one and what is added.
void Sculptor::hold_firmly(Index t, double before, double now) {
  if (!open_ && mesh_.tets.infinite(t)) return;
  const std::int64_t more = price(std::abs(now)) - price(std::abs(before));
  graph_.terminal[t] += now > 0 ? more : -more;
}

}  // namespace filmsticking
