// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/two_sides.h"

#include <tbb/parallel_sort.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <utility>

#include "geometry/parallel.h"
#include "labelling/signed_clusters.h"

namespace filmsticking {
namespace {

// Facets with edges longer than this, in spacings, weigh less, by the fourth power: wide facets go around the
// rim of an open surface from one side to the other.
constexpr double kNear = 2;
// The weight of a facet for the side that a viewpoint is on, as a share of its weight for its tetrahedra. So
// little counts only when clusters have grown. With more, noise and facets along the line of sight would
// outweigh their neighbours.
constexpr double kViewShare = 0.03;
// A facet with so many votes is one of the surface, at whose rim other facets weigh less for joining. Three
// votes leave out 1 % of the points of uneven scans.
constexpr int kRimVotes = 2;
constexpr double kRimWeight = 0.3;

/// The edges of the facets that enough corners vote for.
class SurfaceEdges {
 public:
  SurfaceEdges(const TetrahedralMesh& mesh, const FacetEvidence& evidence, int votes) {
    for (std::size_t t = 0; t < mesh.size(); ++t)
      for (int k = 0; k < 4; ++k) {
        if (mesh.mirror[t][k] < static_cast<Index>(4 * t) + k || evidence.votes[t][k] < votes) continue;
        for (const auto& edge : edges_of(mesh.tets.corners[t], k)) edges_.push_back(edge);
      }
    std::sort(edges_.begin(), edges_.end());
  }

  /// Is a facet on an edge between two facets of the surface, and on no edge of its rim?
  bool carry(const std::array<Index, 4>& corners, int k) const {
    bool carried = false;
    for (const auto& edge : edges_of(corners, k)) {
      const auto [first, last] = std::equal_range(edges_.begin(), edges_.end(), edge);
      if (last - first == 1) return false;
      carried = carried || last != first;
    }
    return carried;
  }

 private:
  using Edge = std::pair<Index, Index>;

  static std::array<Edge, 3> edges_of(const std::array<Index, 4>& corners, int k) {
    std::array<Edge, 3> edges;
    for (int i = 0; i < 3; ++i)
      edges[i] = std::minmax({corners[kFacet[k][i]], corners[kFacet[k][(i + 1) % 3]]});
    return edges;
  }

  std::vector<Edge> edges_;
};

/// The contraction. An edge is a facet, named 4 t + k by the lesser of its two names. Of n tetrahedra,
/// cluster n stands for the side away from the viewpoint, and 4 n + root is the edge between it and another
/// cluster.
class Contraction {
 public:
  Contraction(const TetrahedralMesh& mesh, std::vector<double> weight)
      : mesh_(mesh),
        behind_(static_cast<Index>(mesh.size())),
        weight_(std::move(weight)),
        clusters_(mesh.size() + 1),
        links_(mesh.size() + 1) {
    for (std::size_t e = 0; e < weight_.size(); ++e)
      if (weight_[e] != 0) first_.emplace_back(std::abs(weight_[e]), -static_cast<Index>(e));
    tbb::parallel_sort(first_.begin(), first_.end());
  }

  /// Ends: every contraction leaves one cluster less, and every entry is taken once.
  SignedClusters run(const Cancel& cancel) {
    for (std::uint64_t turns = 0; !first_.empty() || !changed_.empty(); ++turns) {
      if (turns % 4096 == 0) cancel();
      const auto [strength, minus_e] = strongest();
      if (std::abs(weight_[-minus_e]) == strength) contract(-minus_e);
    }
    return std::move(clusters_);
  }

 private:
  using Entry = std::pair<double, Index>;  // strength, minus the edge
  // An edge of a cluster, and the tetrahedron at its other end.
  struct Link {
    Index edge, far;
  };

  Entry strongest() {
    Entry entry;
    if (changed_.empty() || (!first_.empty() && first_.back() > changed_.top()))
      entry = first_.back(), first_.pop_back();
    else
      entry = changed_.top(), changed_.pop();
    return entry;
  }

  std::pair<Index, Index> ends(Index e) const {
    if (e >= view(0)) return {behind_, e - view(0)};
    return {e / 4, mesh_.tets.neighbours[e / 4][e % 4]};
  }

  Index view(Index root) const { return 4 * behind_ + root; }

  // The edges of a cluster, without view(). Those of a single tetrahedron are its facets.
  std::vector<Link>& links(Index root) {
    std::vector<Link>& list = links_[root];
    if (list.empty())
      for (int k = 0; k < 4; ++k) {
        const Index e = std::min(4 * root + k, mesh_.mirror[root][k]);
        if (weight_[e] != 0) list.push_back({e, mesh_.tets.neighbours[root][k]});
      }
    return list;
  }

  // The edge between two clusters, or kNone. Drops the edges that are gone from the shorter list.
  Index between(Index a, Index c) {
    std::vector<Link>* list = &links(a);
    Index other = c;
    if (links(c).size() < list->size()) list = &links(c), other = a;
    Index found = kNone;
    std::size_t kept = 0;
    for (const Link link : *list) {
      if (weight_[link.edge] == 0) continue;
      (*list)[kept++] = link;
      if (clusters_.find(link.far).first == other) found = link.edge;
    }
    list->resize(kept);
    return found;
  }

  // The sign of an edge between roots: that of its weight if both had the sign of their tetrahedra at it.
  int sign_of(Index e) {
    const auto [t, u] = ends(e);
    return clusters_.find(t).second * clusters_.find(u).second;
  }

  void contract(Index e) {
    const auto [t, u] = ends(e);
    auto [a, sign_t] = clusters_.find(t);
    auto [b, sign_u] = clusters_.find(u);
    const int sign = (weight_[e] > 0 ? 1 : -1) * sign_t * sign_u;
    weight_[e] = 0;
    if (b == behind_ || (a != behind_ && links(a).size() < links(b).size())) std::swap(a, b);
    // Edges from both to a third cluster become one; the others of b become a's.
    std::vector<Link> moved;
    for (const Link link : links(b)) {
      if (weight_[link.edge] == 0) continue;
      const Index third = clusters_.find(link.far).first;
      const Index g = a == behind_ ? view(third) : between(a, third);
      if (g == kNone) {
        moved.push_back(link);
        continue;
      }
      add(g, sign * sign_of(link.edge) * sign_of(g) * weight_[link.edge]);
      weight_[link.edge] = 0;
    }
    clusters_.join(a, b, sign);
    if (a != behind_) {
      add(view(a), sign * weight_[view(b)]);
      links_[a].insert(links_[a].end(), moved.begin(), moved.end());
    }
    weight_[view(b)] = 0;
    std::vector<Link>().swap(links_[b]);
  }

  void add(Index e, double weight) {
    if (weight == 0) return;
    weight_[e] += weight;
    if (weight_[e] != 0) changed_.emplace(std::abs(weight_[e]), -e);
  }

  const TetrahedralMesh& mesh_;
  const Index behind_;
  std::vector<double> weight_;  // [edge]; 0: gone
  SignedClusters clusters_;
  std::vector<std::vector<Link>> links_;
  std::vector<Entry> first_;            // of the first weights, rising
  std::priority_queue<Entry> changed_;  // of weights that were added to
};

// Adds edges to the side away from the viewpoint: a facet of the surface weighs for its tetrahedron behind it
// to be there, and for the one before it not to be.
void add_view(const TetrahedralMesh& mesh, const std::vector<Vec3>& sites, const Vec3& viewpoint,
              std::vector<double>& weight) {
  const std::size_t n = mesh.size();
  for (std::size_t t = 0; t < n; ++t)
    for (int k = 0; k < 4; ++k) {
      const double surface = -weight[4 * t + k];
      if (!(surface > 0)) continue;
      const auto& c = mesh.tets.corners[t];
      const Vec3 &a = sites[c[kFacet[k][0]]], &b = sites[c[kFacet[k][1]]], &d = sites[c[kFacet[k][2]]];
      const Vec3 out = (b - a).cross(d - a), ray = viewpoint - (a + b + d) / 3;
      const double lengths = out.norm() * ray.norm();
      if (!(lengths > 0)) continue;
      const double behind = kViewShare * surface * out.dot(ray) / lengths;
      weight[4 * n + t] += behind;
      weight[4 * n + static_cast<std::size_t>(mesh.tets.neighbours[t][k])] -= behind;
    }
}

}  // namespace

std::vector<double> two_sides(const TetrahedralMesh& mesh, const std::vector<Vec3>& sites,
                              const FacetEvidence& evidence, const SiteGeometry& geometry,
                              const Vec3* viewpoint, const Cancel& cancel) {
  std::vector<double> weight(5 * mesh.size(), 0);
  const SurfaceEdges surface(mesh, evidence, kRimVotes);
  parallel_each(mesh.size(), [&](std::size_t t) {
    for (int k = 0; k < 4; ++k) {
      if (mesh.mirror[t][k] < static_cast<Index>(4 * t) + k || !(evidence.area[t][k] > 0)) continue;
      const auto& c = mesh.tets.corners[t];
      const Index i = c[kFacet[k][0]], j = c[kFacet[k][1]], l = c[kFacet[k][2]];
      const double spacing = std::max({geometry.spacing[i], geometry.spacing[j], geometry.spacing[l]});
      const double edge2 = std::max({(sites[i] - sites[j]).squaredNorm(), (sites[j] - sites[l]).squaredNorm(),
                                     (sites[l] - sites[i]).squaredNorm()});
      const double sample = spacing * spacing, near = std::min(1.0, kNear * kNear * sample / edge2);
      const double coupling = kVoteCoupling[evidence.votes[t][k]];
      weight[4 * t + k] = coupling * std::min<double>(evidence.area[t][k], sample) * near * near *
                          (coupling > 0 && !surface.carry(c, k) ? kRimWeight : 1);
    }
  });
  if (viewpoint != nullptr) add_view(mesh, sites, *viewpoint, weight);
  Contraction contraction(mesh, std::move(weight));
  SignedClusters clusters = contraction.run(cancel);

  std::vector<double> hull(mesh.size() + 1, 0);  // [root]: area with its sign less that with the other
  for (std::size_t t = 0; t < mesh.size(); ++t) {
    if (!mesh.tets.infinite(static_cast<Index>(t))) continue;
    const auto [root, sign] = clusters.find(static_cast<Index>(t));
    for (double area : evidence.area[t]) hull[root] += sign * area;
  }
  std::vector<double> side(mesh.size());
  for (std::size_t t = 0; t < mesh.size(); ++t) {
    const auto [root, sign] = clusters.find(static_cast<Index>(t));
    side[t] = hull[root] >= 0 ? -sign : sign;
  }
  return side;
}

}  // namespace filmsticking
