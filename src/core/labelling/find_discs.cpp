// SPDX-License-Identifier: GPL-3.0-or-later
// ManifoldLabels: discs across tunnels and through bridges.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cstddef>
#include <utility>

#include "labelling/manifold_labels.h"

namespace filmsticking {
namespace {

// What a disc costs is asked later.
constexpr double kAnyPrice = 1e100;
// Tetrahedra behind a thread of a dent, not of a tunnel; where there are more, that is asked later as well.
constexpr std::size_t kDent = 200;
// A larger part fills no chance gap.
constexpr std::size_t kLargestDisc = 1000;
// The share of its neighbours' variance off the plane fitted to them from which a site's normal says nothing.
constexpr double kUnsure = 0.1;
// The lining from which samples line a tunnel.
constexpr double kLined = 0.3;

}  // namespace

// How far samples line the tunnel that a disc is across, or the bar that it is through. Their normals are
// across its axis then; around a chance gap in a wall they are along it, and this is negative. It is the sum,
// over the samples at the disc, of a third less the squared cosine between normal and axis: that is a third
// on average for any normals. The normals in noise say nothing.
double ManifoldLabels::lining(const std::vector<Vec3>& sites, const Move& disc) const {
  Eigen::Matrix3d ahead = Eigen::Matrix3d::Zero();
  std::vector<Index> around;
  for (Index t : disc) {
    const auto& c = mesh_.tets.corners[t];
    for (Index v : c)
      if (!census_[v].off()) around.push_back(v);
    for (int k = 0; k < 4; ++k) {
      const Index u = mesh_.tets.neighbours[t][k];
      if (inside_[u] != inside_[t] || std::binary_search(disc.begin(), disc.end(), u)) continue;
      const Vec3& o = sites[c[kFacet[k][0]]];
      const Vec3 n = (sites[c[kFacet[k][1]]] - o).cross(sites[c[kFacet[k][2]]] - o);
      if (n.norm() > 0) ahead += n * n.transpose() / n.norm();
    }
  }
  if (ahead.isZero()) return 0;
  const Vec3 axis = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(ahead).eigenvectors().col(2);
  unique_sorted(around);
  double lining = 0;
  for (Index v : around) {
    const double cosine = axis.dot(geometry_.normal[v]);
    lining += std::max(0.0, 1 - geometry_.variation[v] / kUnsure) * (1.0 / 3 - cosine * cosine);
  }
  return lining;
}

// The narrow tetrahedra of a label at which what is left of it is as wide as one facet: with all three edges
// on the surface.
std::vector<ManifoldLabels::Move> ManifoldLabels::threads(const std::vector<char>& aim, char label) {
  std::vector<Move> moves;
  for (std::size_t s = 0; s < mesh_.size(); ++s) {
    const Index t = static_cast<Index>(s);
    if (inside_[t] != label || aim[t] == label) continue;
    cancel_();
    if (spent()) return {};
    for (int k = 0; k < 4; ++k) {
      const auto& f = kFacet[k];
      const Index u =
          mesh_.tets.neighbours[t][k];  // of this label, so that an edge is at the surface if mixed
      if (inside_[u] != label || mesh_.tets.infinite(u) || !mixed(t, f[0], f[1]) || !mixed(t, f[1], f[2]) ||
          !mixed(t, f[2], f[0]))
        continue;
      moves.push_back({t});
      break;
    }
  }
  return moves;
}

// The parts that differ from earlier labels, connected through facets, in rising order of size.
std::vector<ManifoldLabels::Move> ManifoldLabels::parts_changed(const std::vector<char>& before) const {
  std::vector<char> met(mesh_.size(), 0);
  const auto meet = [&](Index t) {
    const bool first = !met[t] && inside_[t] != before[t];
    met[t] = 1;
    return first;
  };
  std::vector<Move> parts;
  for (std::size_t s = 0; s < mesh_.size(); ++s) {
    if (!meet(static_cast<Index>(s))) continue;
    Move part{static_cast<Index>(s)};
    for (std::size_t i = 0; i < part.size(); ++i)
      for (Index u : mesh_.tets.neighbours[part[i]])
        if (meet(u)) part.push_back(u);
    parts.push_back(std::move(part));
  }
  return smallest_first(std::move(parts));
}

// Where relabelling narrow tetrahedra of a label leaves fewer handles. They follow their neighbours as far as
// that is without a change of topology; what is left of a tunnel then is a thread, which is cut; and all that
// can goes back without a change of topology, but for a disc across each tunnel. Leaves the labels as they
// are.
std::vector<ManifoldLabels::Disc> ManifoldLabels::discs(const std::vector<Vec3>& sites, double radius,
                                                        char label) {
  const std::vector<char> before = inside_;
  const std::vector<Census> census_before = census_;
  const std::vector<char> exempt_before = exempt_;
  LabelCounts counts_before = counts_;
  std::vector<char> aim = inside_;
  for (std::size_t s = 0; s < mesh_.size(); ++s)
    if (aim[s] == label && !mesh_.flat[s] && narrow(static_cast<Index>(s), radius)) aim[s] = !label;
  std::int64_t last = -1;
  // What is cut off from the rest by more than a dent counts as well, but all work does.
  while (counts_.tunnels > last && !spent()) {
    last = counts_.tunnels;
    counts_.visits += static_cast<std::int64_t>(mesh_.size());
    warp(aim);
    name_pieces();
    fill_all(threads(aim, label), label, {kAnyPrice, 0, 0, false, kDent});
  }
  std::vector<Move> moves;
  if (counts_.tunnels > counts_before.tunnels && !spent()) {
    warp(before);
    moves = parts_changed(before);
  }
  inside_ = before;
  census_ = census_before;
  exempt_ = exempt_before;
  counts_before.visits = counts_.visits;
  counts_ = counts_before;
  name_pieces();
  std::vector<Disc> discs;
  for (Move& move : moves) {
    if (move.size() > kLargestDisc) continue;
    const double lined = lining(sites, move);
    if (lined <= kLined) discs.push_back({std::move(move), lined});
  }
  return discs;
}

}  // namespace filmsticking
