// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/caps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

#include "geometry/disjoint_sets.h"
#include "labelling/narrow.h"

namespace filmsticking {
namespace {

// Around a chance gap the samples' normals are those of the gap's cap; in a tunnel they are across its axis.
// The least mean cosine between a cap's facets and the normals at their corners: 15 degrees.
constexpr double kAlong = 0.966;
// Tetrahedra beyond a cap of a dent; a tunnel has more.
constexpr std::size_t kLargestDent = 200;

// A facet is 4 times a tetrahedron, a finite one, plus the corner opposite.
using Facets = std::vector<Index>;

// The narrow facets outside between tetrahedra that are wide, with all corners on the surface.
Facets narrow_facets(const Labelling& labelling, const std::vector<Vec3>& sites, double radius) {
  const auto is_narrow = [&](Index t, int k) {
    for (int j : kFacet[k])
      if (const Index v = labelling.corners(t)[j]; v == kNone || labelling.census(v).off()) return false;
    return narrow_facet(labelling, sites, t, k, radius);
  };
  Facets facets;
  for (std::size_t s = 0; s < labelling.mesh().size(); ++s) {
    const Index t = static_cast<Index>(s);
    if (labelling.label(t) || labelling.infinite(t) || narrow(labelling, t, radius)) continue;
    for (int k = 0; k < 4; ++k) {
      const Index u = labelling.neighbours(t)[k];
      const bool first = t < u || labelling.infinite(u);
      if (first && !labelling.label(u) && !narrow(labelling, u, radius) && is_narrow(t, k))
        facets.push_back(4 * t + k);
    }
  }
  return facets;
}

// An edge that is off the surface, with its facets of a list, by their places there.
struct Edge {
  std::vector<std::size_t> facets;
  std::size_t left;  // of these
};

std::vector<Edge> edges_off_surface(Labelling& labelling, const Facets& facets) {
  struct Use {
    Index v, w;         // the edge
    std::size_t facet;  // its place in the list
    auto key() const { return std::tie(v, w, facet); }
    bool same_edge(const Use& o) const { return v == o.v && w == o.w; }
  };
  std::vector<Use> uses;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const auto& c = labelling.corners(facets[i] / 4);
    const auto& corners = kFacet[facets[i] % 4];
    for (int e = 0; e < 3; ++e) {
      const auto [v, w] = std::minmax(c[corners[e]], c[corners[(e + 1) % 3]]);
      uses.push_back({v, w, i});
    }
  }
  std::sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) { return a.key() < b.key(); });
  std::vector<Edge> edges;
  for (auto use = uses.begin(), end = use; use != uses.end(); use = end) {
    end = std::find_if(use, uses.end(), [&](const Use& u) { return !u.same_edge(*use); });
    const Index t = facets[use->facet] / 4;
    bool off = true;
    labelling.around_edge(t, labelling.corner(t, use->v), labelling.corner(t, use->w),
                          [&](Index u) { return off = !labelling.label(u); });
    if (!off) continue;
    Edge edge;
    for (auto u = use; u != end; ++u) edge.facets.push_back(u->facet);
    edge.left = edge.facets.size();
    edges.push_back(std::move(edge));
  }
  return edges;
}

// [facet]: it may close something. One that is alone at an edge off the surface does not; nor does one that
// is alone without it, and so on.
std::vector<char> closing(std::vector<Edge>& edges, std::size_t facets) {
  std::vector<std::vector<std::size_t>> edges_of(facets);
  for (std::size_t e = 0; e < edges.size(); ++e)
    for (std::size_t i : edges[e].facets) edges_of[i].push_back(e);
  std::vector<char> left(facets, 1);
  std::vector<std::size_t> dropped;
  const auto drop_if_loose = [&](std::size_t i) {
    const auto& own = edges_of[i];
    if (!left[i] || std::none_of(own.begin(), own.end(), [&](std::size_t e) { return edges[e].left == 1; }))
      return;
    left[i] = 0;
    dropped.push_back(i);
  };
  for (std::size_t i = 0; i < facets; ++i) drop_if_loose(i);
  while (!dropped.empty()) {  // ends: a facet is dropped once
    const std::size_t i = dropped.back();
    dropped.pop_back();
    for (std::size_t e : edges_of[i])
      if (--edges[e].left == 1)
        for (std::size_t other : edges[e].facets) drop_if_loose(other);
  }
  return left;
}

// The parts of some facets outside that may close something, connected through edges off the surface.
std::vector<Facets> closing_parts(Labelling& labelling, const Facets& facets) {
  std::vector<Edge> edges = edges_off_surface(labelling, facets);
  const std::vector<char> left = closing(edges, facets.size());
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
  std::vector<Facets> parts(static_cast<std::size_t>(sets.number(set)));
  for (std::size_t i = 0; i < facets.size(); ++i)
    if (left[i]) parts[set[i]].push_back(facets[i]);
  return parts;
}

// Is what is outside beyond a cap, from the tetrahedra on one side of it, no more than a dent?
bool dent(Labelling& labelling, const Move& side, const Facets& cap) {
  const auto in_cap = [&](Index facet) { return std::binary_search(cap.begin(), cap.end(), facet); };
  Marks& seen = labelling.marks;
  seen.clear();
  std::vector<Index> queue;
  for (Index t : side)
    if (!seen.has(t)) seen.add(t), queue.push_back(t);
  for (std::size_t i = 0; i < queue.size(); ++i) {  // ends: each is met once
    if (queue.size() > kLargestDent) return false;
    const Index t = queue[i];
    for (int k = 0; k < 4; ++k) {
      const Index u = labelling.neighbours(t)[k];
      if (labelling.label(u) || seen.has(u) || in_cap(4 * t + k) || in_cap(labelling.mesh().mirror[t][k]))
        continue;
      seen.add(u);
      queue.push_back(u);
    }
  }
  return true;
}

// The tetrahedra on either side of a cap; none if the samples around it do not lie along it.
std::array<Move, 2> sides_of(const Labelling& labelling, const std::vector<Vec3>& sites, const Facets& cap) {
  Vec3 ahead = Vec3::Zero();  // of the first
  double area = 0, along = 0;
  std::array<Move, 2> side;
  for (const Index f : cap) {
    const Index t = f / 4;
    const auto& c = labelling.corners(t);
    const auto& corners = kFacet[f % 4];
    const Vec3& o = sites[c[corners[0]]];
    const Vec3 n = (sites[c[corners[1]]] - o).cross(sites[c[corners[2]]] - o);  // out of t
    if (f == cap.front()) ahead = n;
    area += n.norm();
    for (int j : corners) along += std::abs(n.dot(labelling.geometry().normal[c[j]])) / 3;
    const int front = n.dot(ahead) > 0 ? 0 : 1;
    side[front].push_back(labelling.neighbours(t)[f % 4]);
    side[1 - front].push_back(t);
  }
  if (along < kAlong * area) return {};
  for (Move& move : side) unique_sorted(move);
  return side;
}

}  // namespace

std::vector<Move> caps(Labelling& labelling, const std::vector<Vec3>& sites, double radius) {
  const auto flat = [&](Index t) { return labelling.mesh().flat[t] != 0; };
  std::vector<Move> moves;
  for (const Facets& cap : closing_parts(labelling, narrow_facets(labelling, sites, radius))) {
    std::array<Move, 2> side = sides_of(labelling, sites, cap);
    if (side[1].empty() || dent(labelling, side[0], cap) || dent(labelling, side[1], cap)) continue;
    for (Move& move : side)
      if (std::none_of(move.begin(), move.end(), flat) && labelling.allowed(move))
        moves.push_back(std::move(move));
  }
  std::stable_sort(moves.begin(), moves.end(),
                   [](const Move& a, const Move& b) { return a.size() < b.size(); });
  return moves;
}

}  // namespace filmsticking
