// SPDX-License-Identifier: GPL-3.0-or-later
#include "evidence/sight.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>

#include "geometry/parallel.h"

namespace filmsticking {
namespace {

// How deep the inside is known to be behind a site, and how far sites are from the surface, in spacings.
constexpr double kDepth = 0.5, kSightNoise = 0.5;
// A facet that is nearer to the site than so many spacings may belong to its own part of the surface.
constexpr double kOwnPart = 3;
// Votes are summed as integers, so that their sum does not depend on the order.
constexpr double kFraction = 64;
// Most tetrahedra around a site to look at, and along a line. Rounding can lead a walk in circles.
constexpr int kMostTurns = 400, kMostSteps = 100000;

/// Rays through the tetrahedra.
class Rays {
 public:
  Rays(const TetrahedralMesh& mesh, const std::vector<Vec3>& sites)
      : mesh_(mesh), sites_(sites), seed_(sites.size(), kNone) {
    for (std::size_t t = 0; t < mesh.size(); ++t)
      for (Index v : mesh.tets.corners[t])
        if (v != kNone) seed_[v] = static_cast<Index>(t);
  }

  /// Returns whether the ray leaves the hull. Calls visit(t, k, begin, end) for the finite tetrahedra from
  /// site v on, up to `length`, with the facet k through which the ray leaves t and the distances at which it
  /// enters and leaves.
  template <class Visit>
  bool walk(Index v, const Vec3& direction, double length, const Visit& visit) const {
    const Vec3& origin = sites_[v];
    Index t = first(v, direction);
    if (t == kNone || mesh_.tets.infinite(t)) return t != kNone;
    int from = -1;
    double begin = 0;
    for (int step = 0; step < kMostSteps; ++step) {
      double end = std::numeric_limits<double>::infinity();
      int to = -1;
      for (int k = 0; k < 4; ++k) {
        if (step == 0 ? mesh_.tets.corners[t][k] != v : k == from) continue;
        const Vec3 normal = outward(t, k);
        const double slope = normal.dot(direction);
        if (!(slope > 0)) continue;
        const double at = normal.dot(sites_[mesh_.tets.corners[t][kFacet[k][0]]] - origin) / slope;
        if (at < end) end = at, to = k;
      }
      if (to < 0) return false;
      end = std::max(begin, end);
      visit(t, to, begin, std::min(end, length));
      if (end >= length) return false;
      const Index across = mesh_.mirror[t][to];
      t = across / 4, from = across % 4, begin = end;
      if (mesh_.tets.infinite(t)) return true;
    }
    return false;
  }

 private:
  int corner(Index t, Index v) const {
    const auto& c = mesh_.tets.corners[t];
    return static_cast<int>(std::find(c.begin(), c.end(), v) - c.begin());
  }

  Vec3 outward(Index t, int k) const {
    const auto& c = mesh_.tets.corners[t];
    const Vec3& a = sites_[c[kFacet[k][0]]];
    return (sites_[c[kFacet[k][1]]] - a).cross(sites_[c[kFacet[k][2]]] - a);
  }

  // The tetrahedron at v that a ray from v enters; kNone where rounding hides it.
  Index first(Index v, const Vec3& direction) const {
    Index t = seed_[v];
    for (int turn = 0; turn < kMostTurns; ++turn) {
      const auto& c = mesh_.tets.corners[t];
      int leave = -1;
      if (mesh_.tets.infinite(t)) {
        const int k = corner(t, kNone);
        if (!(outward(t, k).dot(direction) > 0)) return t;  // away from the hull
        leave = k;
      }
      for (int i = 0; i < 4 && leave < 0; ++i) {
        const int k = (i + turn) % 4;  // another order each time: a fixed one can lead in circles
        if (c[k] != v && outward(t, k).dot(direction) > 0) leave = k;
      }
      if (leave < 0) return t;
      t = mesh_.tets.neighbours[t][leave];
    }
    return kNone;
  }

  const TetrahedralMesh& mesh_;
  const std::vector<Vec3>& sites_;
  std::vector<Index> seed_;  // a tetrahedron at each site
};

}  // namespace

Sight lines_of_sight(const TetrahedralMesh& mesh, const std::vector<Vec3>& sites,
                     const SiteGeometry& geometry, const FacetEvidence& evidence,
                     const std::vector<Vec3>& viewpoints, const Cancel& cancel) {
  const Rays rays(mesh, sites);
  std::vector<std::atomic<std::int64_t>> votes(mesh.size());
  std::atomic<std::int64_t> lines{0}, leaving{0}, blocked{0};
  const auto add = [&](Index t, double vote) {
    votes[t].fetch_add(std::llround(vote * kFraction), std::memory_order_relaxed);
  };
  parallel_chunks(sites.size(), 1024, [&](std::size_t, std::size_t begin_site, std::size_t end_site) {
    cancel();
    for (std::size_t s = begin_site; s < end_site; ++s) {
      const Index v = static_cast<Index>(s);
      const Vec3 way = viewpoints[s] - sites[s];
      const double length = way.norm(), spacing = geometry.spacing[s];
      if (!(length > 0) || !std::isfinite(length)) continue;
      const Vec3 direction = way / length;
      bool passed = false;
      leaving += rays.walk(v, direction, length, [&](Index t, int k, double begin, double end) {
        const double from_site = (begin + end) / 2 / (kSightNoise * spacing);
        const double sure = 1 - std::exp(-from_site * from_site / 2);
        add(t, -sure * std::min(1.0, (end - begin) / spacing));
        passed |= end > kOwnPart * spacing && end < length && evidence.votes[t][k] == 3;
      });
      const double depth = kDepth * spacing;
      rays.walk(v, -direction, depth,
                [&](Index t, int, double begin, double end) { add(t, (end - begin) / depth); });
      ++lines;
      blocked += passed;
    }
  });
  Sight sight;
  sight.lines = lines, sight.leaving = leaving, sight.blocked = blocked;
  sight.votes.resize(mesh.size());
  parallel_each(mesh.size(), [&](std::size_t t) {
    sight.votes[t] = static_cast<float>(static_cast<double>(votes[t].load()) / kFraction);
  });
  return sight;
}

}  // namespace filmsticking
