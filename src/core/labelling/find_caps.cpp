// SPDX-License-Identifier: GPL-3.0-or-later
// ManifoldLabels: caps, where plugs of narrow tetrahedra leave a tunnel open.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

#include "geometry/disjoint_sets.h"
#include "geometry/triangle_circle.h"
#include "labelling/manifold_labels.h"

namespace filmsticking {
namespace {

// The samples around a chance gap have normals along it; those that line a tunnel, across it. Of a cap, the
// least mean cosine between the facets' normals and those at their corners: 15 degrees.
constexpr double kAlong = 0.966;
// Tetrahedra beyond a cap that is no cap of a tunnel.
constexpr std::size_t kLargestDent = 200;

}  // namespace

// Has a facet of finite corners a circumcircle of less than this radius, in the largest spacing of these?
bool ManifoldLabels::narrow_facet(const std::vector<Vec3>& sites, Index t, int k, double radius) const {
  const auto& c = mesh_.tets.corners[t];
  const Index i = c[kFacet[k][0]], j = c[kFacet[k][1]], l = c[kFacet[k][2]];
  const double widest = radius * std::max({geometry_.spacing[i], geometry_.spacing[j], geometry_.spacing[l]});
  return circumradius2(sites[i], sites[j], sites[l]) < widest * widest;
}

// The narrow facets outside between tetrahedra that are not: each as 4 times a tetrahedron, a finite one,
// plus the corner opposite.
std::vector<Index> ManifoldLabels::narrow_facets(const std::vector<Vec3>& sites, double radius) const {
  const auto is_narrow = [&](Index t, int k) {
    const auto& c = mesh_.tets.corners[t];
    for (int j : kFacet[k])
      if (c[j] == kNone || census_[c[j]].off()) return false;
    return narrow_facet(sites, t, k, radius);
  };
  std::vector<Index> facets;
  for (std::size_t s = 0; s < mesh_.size(); ++s) {
    const Index t = static_cast<Index>(s);
    if (inside_[t] || mesh_.tets.infinite(t) || narrow(t, radius)) continue;
    for (int k = 0; k < 4; ++k) {
      const Index u = mesh_.tets.neighbours[t][k];
      const bool first = t < u || mesh_.tets.infinite(u);
      if (first && !inside_[u] && !narrow(u, radius) && is_narrow(t, k)) facets.push_back(4 * t + k);
    }
  }
  return facets;
}

// The parts of some facets outside that may close something, connected through edges off the surface. One
// that is alone at such an edge closes nothing; nor does one that is so without it, and so on.
std::vector<std::vector<Index>> ManifoldLabels::closing_parts(const std::vector<Index>& facets) {
  struct Use {
    Index v, w;         // the edge
    std::size_t facet;  // its place in the list
    auto key() const { return std::tie(v, w, facet); }
    bool same_edge(const Use& o) const { return v == o.v && w == o.w; }
  };
  std::vector<Use> uses;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const auto& c = mesh_.tets.corners[facets[i] / 4];
    const auto& corners = kFacet[facets[i] % 4];
    for (int e = 0; e < 3; ++e) {
      const auto [v, w] = std::minmax(c[corners[e]], c[corners[(e + 1) % 3]]);
      uses.push_back({v, w, i});
    }
  }
  std::sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) { return a.key() < b.key(); });
  struct Edge {
    std::vector<std::size_t> facets;
    std::size_t left;  // of these
  };
  std::vector<Edge> edges;  // off the surface
  std::vector<std::vector<std::size_t>> edges_of(facets.size());
  for (auto use = uses.begin(), end = use; use != uses.end(); use = end) {
    end = std::find_if(use, uses.end(), [&](const Use& u) { return !u.same_edge(*use); });
    const Index t = facets[use->facet] / 4;
    bool off = true;
    around_edge(t, corner(t, use->v), corner(t, use->w), [&](Index u) { return off = !inside_[u]; });
    if (!off) continue;
    Edge edge;
    for (auto u = use; u != end; ++u)
      edge.facets.push_back(u->facet), edges_of[u->facet].push_back(edges.size());
    edge.left = edge.facets.size();
    edges.push_back(std::move(edge));
  }
  std::vector<char> left(facets.size(), 1);
  std::vector<std::size_t> dropped;
  const auto drop_if_loose = [&](std::size_t i) {
    const auto& own = edges_of[i];
    if (!left[i] || std::none_of(own.begin(), own.end(), [&](std::size_t e) { return edges[e].left == 1; }))
      return;
    left[i] = 0;
    dropped.push_back(i);
  };
  for (std::size_t i = 0; i < facets.size(); ++i) drop_if_loose(i);
  while (!dropped.empty()) {  // ends: a facet is dropped once
    const std::size_t i = dropped.back();
    dropped.pop_back();
    for (std::size_t e : edges_of[i])
      if (--edges[e].left == 1)
        for (std::size_t other : edges[e].facets) drop_if_loose(other);
  }
  DisjointSets sets(facets.size());
  for (const Edge& edge : edges) {
    std::size_t last = facets.size();
    for (std::size_t i : edge.facets) {
      if (!left[i]) continue;
      if (last < facets.size()) sets.unite(static_cast<Index>(last), static_cast<Index>(i));
      last = i;
    }
  }
  std::vector<Index> set;
  std::vector<std::vector<Index>> parts(static_cast<std::size_t>(sets.number(set)));
  for (std::size_t i = 0; i < facets.size(); ++i)
    if (left[i]) parts[set[i]].push_back(facets[i]);
  return parts;
}

// Is all that is outside beyond a cap, from the tetrahedra on one side of it, no more than a dent?
bool ManifoldLabels::dent(const Move& side, const std::vector<Index>& cap) {
  ++stamp_;
  waiting_.clear();
  for (Index t : side)
    if (seen_[t] != stamp_) seen_[t] = stamp_, waiting_.push_back(t);
  // Ends: each is met once.
  for (std::size_t i = 0; i < waiting_.size(); ++i) {
    if (waiting_.size() > kLargestDent) return false;
    const Index t = waiting_[i];
    for (int k = 0; k < 4; ++k) {
      const Index u = mesh_.tets.neighbours[t][k];
      if (inside_[u] || seen_[u] == stamp_ || std::binary_search(cap.begin(), cap.end(), 4 * t + k) ||
          std::binary_search(cap.begin(), cap.end(), mesh_.mirror[t][k]))
        continue;
      seen_[u] = stamp_;
      waiting_.push_back(u);
    }
  }
  return true;
}

// The tetrahedra on either side of caps that the samples around them lie along, in rising order of size.
std::vector<ManifoldLabels::Move> ManifoldLabels::caps(const std::vector<Vec3>& sites, double radius) {
  std::vector<Move> moves;
  for (const std::vector<Index>& cap : closing_parts(narrow_facets(sites, radius))) {
    if (cap.empty()) continue;
    Vec3 ahead = Vec3::Zero();  // of the first
    double area = 0, along = 0;
    Move side[2];
    for (const Index f : cap) {
      const Index t = f / 4;
      const auto& c = mesh_.tets.corners[t];
      const auto& corners = kFacet[f % 4];
      const Vec3& o = sites[c[corners[0]]];
      const Vec3 n = (sites[c[corners[1]]] - o).cross(sites[c[corners[2]]] - o);  // out of t
      if (f == cap.front()) ahead = n;
      area += n.norm();
      for (int j : corners) along += std::abs(n.dot(geometry_.normal[c[j]])) / 3;
      const int front = n.dot(ahead) > 0 ? 0 : 1;
      side[front].push_back(mesh_.tets.neighbours[t][f % 4]);
      side[1 - front].push_back(t);
    }
    if (along < kAlong * area) continue;
    for (Move& move : side) unique_sorted(move);
    if (dent(side[0], cap) || dent(side[1], cap)) continue;
    for (Move& move : side) {
      const bool flat = std::any_of(move.begin(), move.end(), [&](Index t) { return mesh_.flat[t] != 0; });
      if (!flat && allowed(move)) moves.push_back(std::move(move));
    }
  }
  std::stable_sort(moves.begin(), moves.end(),
                   [](const Move& a, const Move& b) { return a.size() < b.size(); });
  return moves;
}

}  // namespace filmsticking
