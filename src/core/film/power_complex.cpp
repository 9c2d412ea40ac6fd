// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/power_complex.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "delaunay/delaunay.h"
#include "delaunay/regular.h"
#include "geometry/parallel.h"

namespace filmsticking {
namespace {

// A walk visits 9 to 20 tetrahedra; only a cycle by rounding takes so many.
constexpr int kLongestWalk = 100000;

// Visibility walk: through the first facet that has x on its other side.
Index walk(const Tetrahedra& tets, const std::vector<Vec3>& sites, Index t, const Vec3& x) {
  Index from = kNone;
  for (int steps = 0; steps < kLongestWalk && !tets.infinite(t); ++steps) {
    const auto& c = tets.corners[t];
    Index next = kNone;
    for (int k = 0; k < 4 && next == kNone; ++k) {
      const Index u = tets.neighbours[t][k];
      if (u == from) continue;
      const Vec3 &a = sites[c[kFacet[k][0]]], &b = sites[c[kFacet[k][1]]], &d = sites[c[kFacet[k][2]]];
      if ((b - a).cross(d - a).dot(x - a) > 0) next = u;
    }
    if (next == kNone) return t;
    from = t, t = next;
  }
  return t;
}

// [tetrahedron]: the one at its centre; of infinite ones, themselves.
UnsetVector<Index> flow_to(const Tetrahedra& tets, const std::vector<Vec3>& sites,
                           const UnsetVector<Vec3>& centre, const std::vector<char>& wanted) {
  UnsetVector<Index> flow(tets.size());
  parallel_each(tets.size(), [&](std::size_t t) {
    if (!wanted.empty() && !wanted[t]) return;
    const auto own = static_cast<Index>(t);
    flow[t] = tets.infinite(own) ? own : walk(tets, sites, own, centre[t]);
  });
  return flow;
}

}  // namespace

PowerComplex::PowerComplex(std::vector<Vec3> sites, std::vector<double> weights,
                           const TriangulationLimits& limits)
    : sites_(std::move(sites)),
      weights_(std::move(weights)),
      tets_(weights_.empty() ? delaunay_tetrahedra(sites_, limits)
                             : regular_tetrahedra(sites_, weights_, limits)) {
  describe();
}

PowerComplex::PowerComplex(std::vector<Vec3> sites, Tetrahedra tets)
    : sites_(std::move(sites)), tets_(std::move(tets)) {
  describe();
}

void PowerComplex::describe() {
  centre_.resize(size());
  flat_.resize(size());
  parallel_each(size(), [&](std::size_t t) {
    flat_[t] = 0;
    if (tets_.infinite(static_cast<Index>(t))) return;
    const auto& c = tets_.corners[t];
    const Vec3& a = sites_[c[0]];
    const Vec3 u = sites_[c[1]] - a, v = sites_[c[2]] - a, w = sites_[c[3]] - a;
    const auto lift = [&](const Vec3& p, int k) {
      return weights_.empty() ? p.squaredNorm() : p.squaredNorm() - weights_[c[k]] + weights_[c[0]];
    };
    const Vec3 uv = u.cross(v), vw = v.cross(w), wu = w.cross(u);
    const double volume6 = u.dot(vw);
    centre_[t] = a;
    if (volume6 != 0) centre_[t] += (lift(u, 1) * vw + lift(v, 2) * wu + lift(w, 3) * uv) / (2 * volume6);
    const double face = std::max({uv.norm(), vw.norm(), wu.norm(), (v - u).cross(w - u).norm()});
    flat_[t] = static_cast<char>(std::abs(volume6) <= kFlat * face);
  });
  seed_.assign(sites_.size(), kNone);
  for (std::size_t t = 0; t < size(); ++t) {
    if (tets_.infinite(static_cast<Index>(t))) continue;
    any_ = static_cast<Index>(t);
    for (const Index v : tets_.corners[t]) seed_[v] = static_cast<Index>(t);
  }
}

Index PowerComplex::locate(const Vec3& x, Index near) const {
  const bool known = near != kNone && static_cast<std::size_t>(near) < seed_.size() && seed_[near] != kNone;
  return walk(tets_, sites_, known ? seed_[near] : any_, x);
}

const UnsetVector<Index>& PowerComplex::flow() const {
  if (flow_.size() != size()) flow_ = flow_to(tets_, sites_, centre_, {});
  return flow_;
}

UnsetVector<Index> flow_map(const TetrahedralMesh& mesh, const std::vector<Vec3>& sites,
                            const std::vector<char>& wanted) {
  return flow_to(mesh.tets, sites, mesh.circumcentre, wanted);
}

}  // namespace filmsticking
