// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/discs.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cstddef>
#include <utility>

#include "labelling/narrow.h"
#include "labelling/warp.h"

namespace filmsticking {
namespace {

// The cost of a disc counts later.
constexpr double kAnyPrice = 1e100;
// Tetrahedra behind a thread that ends in a dent, not in a tunnel; where there are more, that counts later
// too.
constexpr std::size_t kDent = 200;
// A larger part fills no chance gap.
constexpr std::size_t kLargestDisc = 1000;
// From this share of its neighbours' variance off the plane fitted to them, a site's normal says nothing.
constexpr double kUnsure = 0.1;
// From this lining on, samples line a tunnel.
constexpr double kLined = 0.3;

// The tetrahedra of a label, but not of the aim, at which what is left of the label is as wide as one facet:
// with all three edges on the surface.
std::vector<Move> threads(Labelling& labelling, const std::vector<char>& aim, char label) {
  std::vector<Move> moves;
  for (std::size_t s = 0; s < aim.size(); ++s) {
    const Index t = static_cast<Index>(s);
    if (labelling.label(t) != label || aim[t] == label) continue;
    labelling.stop_if_cancelled();
    if (labelling.spent()) return {};
    for (int k = 0; k < 4; ++k) {
      const auto& f = kFacet[k];
      const Index u = labelling.neighbours(t)[k];  // of this label: an edge is on the surface if it is mixed
      if (labelling.label(u) != label || labelling.infinite(u) || !labelling.mixed(t, f[0], f[1]) ||
          !labelling.mixed(t, f[1], f[2]) || !labelling.mixed(t, f[2], f[0]))
        continue;
      moves.push_back({t});
      break;
    }
  }
  return moves;
}

// The parts that differ from earlier labels, connected through facets, smallest first.
std::vector<Move> parts_changed(const Labelling& labelling, const std::vector<char>& before) {
  std::vector<char> met(before.size(), 0);
  const auto meet = [&](Index t) {
    const bool first = !met[t] && labelling.label(t) != before[t];
    met[t] = 1;
    return first;
  };
  std::vector<Move> parts;
  for (std::size_t s = 0; s < before.size(); ++s) {
    if (!meet(static_cast<Index>(s))) continue;
    Move part{static_cast<Index>(s)};
    for (std::size_t i = 0; i < part.size(); ++i)
      for (Index u : labelling.neighbours(part[i]))
        if (meet(u)) part.push_back(u);
    parts.push_back(std::move(part));
  }
  return smallest_first(std::move(parts));
}

}  // namespace

double lining(const Labelling& labelling, const std::vector<Vec3>& sites, const Move& disc) {
  const SiteGeometry& geometry = labelling.geometry();
  Eigen::Matrix3d ahead = Eigen::Matrix3d::Zero();
  std::vector<Index> around;
  for (Index t : disc) {
    const auto& c = labelling.corners(t);
    for (Index v : c)
      if (!labelling.census(v).off()) around.push_back(v);
    for (int k = 0; k < 4; ++k) {
      const Index u = labelling.neighbours(t)[k];
      if (labelling.label(u) != labelling.label(t) || std::binary_search(disc.begin(), disc.end(), u))
        continue;
      const Vec3& o = sites[c[kFacet[k][0]]];
      const Vec3 n = (sites[c[kFacet[k][1]]] - o).cross(sites[c[kFacet[k][2]]] - o);
      if (n.norm() > 0) ahead += n * n.transpose() / n.norm();
    }
  }
  if (ahead.isZero()) return 0;
  const Vec3 axis = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(ahead).eigenvectors().col(2);
  unique_sorted(around);
  double sum = 0;
  for (Index v : around) {
    const double cosine = axis.dot(geometry.normal[v]);
    sum += std::max(0.0, 1 - geometry.variation[v] / kUnsure) * (1.0 / 3 - cosine * cosine);
  }
  return sum;
}

// Narrow tetrahedra follow their neighbours as far as the topology allows. What is left of a tunnel then is a
// thread, which is cut. At last all that can goes back without a change of topology: a disc across each
// tunnel stays.
std::vector<Disc> discs(Mending& mending, const std::vector<Vec3>& sites, double radius, char label) {
  Labelling& labelling = mending.labelling;
  const TetrahedralMesh& mesh = labelling.mesh();
  LabelCounts& counts = labelling.counts;
  Labelling::Snapshot before = labelling.snapshot();
  std::vector<char> aim = before.labels;
  for (std::size_t s = 0; s < mesh.size(); ++s)
    if (aim[s] == label && !mesh.flat[s] && narrow(labelling, static_cast<Index>(s), radius)) aim[s] = !label;
  // What a cut takes apart counts as well if it is more than a dent; but all work does.
  // Cuts make new threads. Those that were tried in vain are not tried again.
  std::vector<char> tried(mesh.size(), 0);
  for (std::int64_t last = -1; counts.tunnels > last && !labelling.spent();) {
    last = counts.tunnels;
    counts.visits += static_cast<std::int64_t>(mesh.size());
    warp(labelling, aim);
    mending.name_pieces();
    std::vector<Move> all = threads(labelling, aim, label);
    all.erase(std::remove_if(all.begin(), all.end(), [&](const Move& m) { return tried[m[0]]; }), all.end());
    for (const Move& thread : all) tried[thread[0]] = 1;
    mending.try_all(all, label, {kAnyPrice, 0, 0, false, kDent});
  }
  std::vector<Move> moves;
  if (counts.tunnels > before.counts.tunnels && !labelling.spent()) {
    warp(labelling, before.labels);
    moves = parts_changed(labelling, before.labels);
  }
  labelling.restore(std::move(before));
  mending.name_pieces();
  std::vector<Disc> found;
  for (Move& move : moves) {
    if (move.size() > kLargestDisc) continue;
    const double lined = lining(labelling, sites, move);
    if (lined <= kLined) found.push_back({std::move(move), lined});
  }
  return found;
}

}  // namespace filmsticking
