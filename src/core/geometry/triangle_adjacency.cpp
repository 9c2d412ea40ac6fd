// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/triangle_adjacency.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <utility>

#include "geometry/disjoint_sets.h"
#include "geometry/parallel.h"

namespace filmsticking {
namespace {

Index target(const std::vector<Corners>& triangles, Index h) { return triangles[h / 3][next_in_face(h) % 3]; }

// Half-edges in buckets of their end with fewer of them, so that the apex of a wide cone is never searched.
struct HalfEdgesByEnd {
  struct HalfEdge {
    Index other;         // end
    std::uint32_t code;  // 2h, or 2h + 1 if h runs to the end of the bucket
  };
  std::vector<Index> degree, offset;
  std::vector<HalfEdge> half_edge;
  HalfEdgesByEnd(const std::vector<Corners>& triangles, Index vertex_count)
      : degree(vertex_count), offset(vertex_count + 1, 0), half_edge(triangles.size() * 3) {
    // A counting sort; the order in a bucket does not matter.
    std::vector<std::atomic<Index>> count(vertex_count);
    const auto add = [&](Index v) { return count[v].fetch_add(1, std::memory_order_relaxed); };
    parallel_each(count.size(), [&](std::size_t v) { count[v].store(0, std::memory_order_relaxed); });
    parallel_each(triangles.size(), [&](std::size_t t) {
      for (Index v : triangles[t]) add(v);
    });
    parallel_each(count.size(), [&](std::size_t v) { degree[v] = count[v].exchange(0); });
    parallel_each(triangles.size(), [&](std::size_t t) {
      for (int k = 0; k < 3; ++k) add(end(triangles[t][k], triangles[t][(k + 1) % 3]));
    });
    for (std::size_t v = 0; v < count.size(); ++v) {
      offset[v + 1] = offset[v] + count[v].load(std::memory_order_relaxed);
      count[v].store(offset[v], std::memory_order_relaxed);
    }
    parallel_each(triangles.size(), [&](std::size_t t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Index a = triangles[t][k], b = triangles[t][(k + 1) % 3], at = end(a, b);
        half_edge[add(at)] = {at == a ? b : a, static_cast<std::uint32_t>(2 * (3 * t + k) + (at == b))};
      }
    });
  }
  Index end(Index a, Index b) const { return std::pair(degree[a], a) < std::pair(degree[b], b) ? a : b; }
};

// The half-edges on the edge of h: how many run back, how many run the same way, and the last that runs back.
struct EdgeUse {
  Index back = kNone;
  int opposite = 0, same = 0;
};

EdgeUse use_of(const std::vector<Corners>& triangles, const HalfEdgesByEnd& edges, Index h) {
  const Index a = triangles[h / 3][h % 3], b = target(triangles, h), end = edges.end(a, b);
  const Index other = end == a ? b : a;
  EdgeUse use;
  for (Index k = edges.offset[end]; k < edges.offset[end + 1]; ++k) {
    const auto& g = edges.half_edge[k];
    if (g.other != other) continue;
    if ((g.code & 1) == (end == b))
      ++use.same;
    else
      use.back = static_cast<Index>(g.code / 2), ++use.opposite;
  }
  return use;
}

// Do the faces at every vertex hang together? The twins pair half-edges, so that turning around a vertex
// comes to an open end or back to the start. `distinct`: do they have different edges there, too?
bool single_rings(const std::vector<Corners>& triangles, const std::vector<Index>& twin,
                  const std::vector<Index>& degree, bool distinct) {
  // Any fan at a vertex will do: if there are several, none has all faces.
  std::vector<std::atomic<Index>> some(degree.size());
  parallel_each(some.size(), [&](std::size_t v) { some[v].store(kNone, std::memory_order_relaxed); });
  parallel_each(twin.size(), [&](std::size_t h) {
    some[triangles[h / 3][h % 3]].store(static_cast<Index>(h), std::memory_order_relaxed);
  });
  std::atomic<bool> single{true};
  parallel_chunks(some.size(), 1024, [&](std::size_t, std::size_t begin, std::size_t end) {
    std::vector<Index> ends;
    for (std::size_t v = begin; v < end; ++v) {
      const Index h = some[v].load(std::memory_order_relaxed);
      if (h == kNone) continue;
      Index first = h;  // the open end of the fan, or any start of a ring
      while (twin[first] != kNone && next_in_face(twin[first]) != h) first = next_in_face(twin[first]);
      Index g = first, last = first, faces = 0;
      ends.clear();
      do {
        ++faces;
        if (distinct) ends.push_back(target(triangles, g));
        last = prev_in_face(g);
        g = twin[last];
      } while (g != kNone && g != first);
      if (faces != degree[v]) single = false;
      if (!distinct) continue;
      if (g == kNone) ends.push_back(triangles[last / 3][last % 3]);
      std::sort(ends.begin(), ends.end());
      if (std::adjacent_find(ends.begin(), ends.end()) != ends.end()) single = false;
    }
  });
  return single;
}

// Turns around the origin of a half-edge; at a boundary it goes on from the start in the other direction.
class FaceTurn {
 public:
  FaceTurn(const std::vector<Index>& twins, Index start) : twins_(twins), start_(start), at_(start) {}

  Index at() const { return at_; }
  bool done() const { return done_; }

  void turn() {
    if (!back_) {
      const Index next = twins_[prev_in_face(at_)];
      done_ = next == start_;
      if (next != kNone) at_ = next;
      if (next != kNone) return;
      back_ = true, at_ = start_;
    }
    done_ = twins_[at_] == kNone;
    if (!done_) at_ = next_in_face(twins_[at_]);
  }

 private:
  const std::vector<Index>& twins_;
  Index start_, at_;
  bool back_ = false, done_ = false;
};

}  // namespace

std::vector<Index> half_edge_twins(const std::vector<Corners>& triangles, Index vertex_count) {
  const HalfEdgesByEnd edges(triangles, vertex_count);
  std::vector<Index> twin(triangles.size() * 3, kNone);
  parallel_each(twin.size(), [&](std::size_t h) {
    const EdgeUse use = use_of(triangles, edges, static_cast<Index>(h));
    if (use.opposite == 1 && use.same == 1) twin[h] = use.back;
  });
  return twin;
}

ManifoldCheck check_manifold(const std::vector<Corners>& triangles, Index vertex_count,
                             std::vector<Index>* twins) {
  ManifoldCheck check;
  for (const Corners& t : triangles) {
    for (Index v : t)
      if (v < 0 || v >= vertex_count) check.indices_valid = false;
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) check.indices_valid = false;
  }
  if (!check.indices_valid || triangles.empty()) {
    check.edges_simple = check.closed = check.oriented = check.single_rings = false;
    return check;
  }
  const HalfEdgesByEnd edges(triangles, vertex_count);
  std::vector<Index> twin(triangles.size() * 3, kNone);
  enum : char {
    kFine,
    kAlone,
    kTurned,
    kCrowded
  };  // an edge with one face, two that disagree, more than two
  std::vector<char> state(twin.size(), kFine);
  parallel_each(twin.size(), [&](std::size_t h) {
    const EdgeUse use = use_of(triangles, edges, static_cast<Index>(h));
    if (use.opposite == 1 && use.same == 1) twin[h] = use.back;
    const int faces = use.opposite + use.same;
    state[h] = faces > 2 ? kCrowded : faces == 1 ? kAlone : use.same == 2 ? kTurned : kFine;
  });
  check.boundary_edges = std::count(state.begin(), state.end(), kAlone);
  check.edges_simple = std::count(state.begin(), state.end(), kCrowded) == 0;
  check.oriented = std::count(state.begin(), state.end(), kTurned) == 0;
  check.closed = check.edges_simple && check.boundary_edges == 0;
  if (!check.edges_simple || !check.oriented) {
    check.single_rings = false;
    return check;
  }
  check.single_rings = single_rings(triangles, twin, edges.degree, false);
  if (twins != nullptr) *twins = std::move(twin);
  return check;
}

ManifoldCheck check_manifold_with_twins(const std::vector<Corners>& triangles, Index vertex_count,
                                        const std::vector<Index>& twins) {
  ManifoldCheck check;
  std::vector<std::atomic<Index>> count(vertex_count);
  parallel_each(count.size(), [&](std::size_t v) { count[v].store(0, std::memory_order_relaxed); });
  std::atomic<bool> valid{!triangles.empty() && twins.size() == 3 * triangles.size()}, paired{true};
  std::atomic<std::int64_t> alone{0};
  if (valid)
    parallel_each(triangles.size(), [&](std::size_t t) {
      const Corners& c = triangles[t];
      if (std::min({c[0], c[1], c[2]}) < 0 || std::max({c[0], c[1], c[2]}) >= vertex_count || c[0] == c[1] ||
          c[1] == c[2] || c[2] == c[0]) {
        valid = false;
        return;
      }
      for (Index k = 0; k < 3; ++k) {
        count[c[k]].fetch_add(1, std::memory_order_relaxed);
        const Index h = static_cast<Index>(3 * t) + k, g = twins[h];
        if (g == kNone)
          ++alone;
        else if (g < 0 || g >= static_cast<Index>(twins.size()) || g == h || twins[g] != h ||
                 triangles[g / 3][g % 3] != c[(k + 1) % 3] || target(triangles, g) != c[k])
          paired = false;
      }
    });
  check.indices_valid = valid;
  check.edges_simple = valid && paired;
  check.boundary_edges = alone;
  check.closed = check.edges_simple && alone == 0;
  check.oriented = check.edges_simple;
  check.single_rings = false;
  if (!check.edges_simple) return check;
  std::vector<Index> degree(count.size());
  parallel_each(count.size(), [&](std::size_t v) { degree[v] = count[v].load(std::memory_order_relaxed); });
  // If the faces at every vertex form one ring or fan of distinct edges, no edge has more than two faces.
  check.single_rings = single_rings(triangles, twins, degree, true);
  return check;
}

bool have_edge(const std::vector<Corners>& triangles, const std::vector<Index>& twins, Index g, Index k) {
  const auto corner = [&](Index h) { return triangles[h / 3][h % 3]; };
  const Index to_g = corner(k), to_k = corner(g);
  FaceTurn one(twins, g), other(twins, k);
  while (!one.done() && !other.done()) {
    if (corner(next_in_face(one.at())) == to_g || corner(next_in_face(other.at())) == to_k) return true;
    if (corner(prev_in_face(one.at())) == to_g || corner(prev_in_face(other.at())) == to_k) return true;
    one.turn(), other.turn();
  }
  return false;
}

void flip_edge(std::vector<Corners>& triangles, std::vector<Index>& twins, Index h) {
  const Index u = twins[h];
  const Index h1 = next_in_face(h), h2 = prev_in_face(h), u1 = next_in_face(u), u2 = prev_in_face(u);
  const auto corner = [&](Index g) -> Index& { return triangles[g / 3][g % 3]; };
  const Index a = corner(h), b = corner(h1), c = corner(h2), d = corner(u2);
  const Index bc = twins[h1], ca = twins[h2], ad = twins[u1], db = twins[u2];
  const auto join = [&](Index g, Index k) {
    twins[g] = k;
    if (k != kNone) twins[k] = g;
  };
  corner(h) = d, corner(h1) = c, corner(h2) = a;
  corner(u) = c, corner(u1) = d, corner(u2) = b;
  join(h1, ca), join(h2, ad), join(u1, db), join(u2, bc);
}

Index connected_components(const std::vector<Index>& twins, std::vector<Index>& component) {
  DisjointSets sets(twins.size() / 3);
  parallel_each(twins.size(), [&](std::size_t h) {
    if (twins[h] != kNone && twins[h] < static_cast<Index>(h))
      sets.unite(static_cast<Index>(h / 3), twins[h] / 3);
  });
  return sets.number(component);
}

// Ends: the fan at a vertex bounds the inner turn, and a loop returns to its start.
std::int64_t boundary_loops(const std::vector<Index>& twin) {
  std::vector<char> seen(twin.size(), 0);
  std::int64_t loops = 0;
  for (Index h = 0; h < static_cast<Index>(twin.size()); ++h) {
    if (twin[h] != kNone || seen[h]) continue;
    ++loops;
    for (Index g = h; !seen[g];) {
      seen[g] = 1;
      for (g = next_in_face(g); twin[g] != kNone;) g = next_in_face(twin[g]);
    }
  }
  return loops;
}

SurfaceTopology::SurfaceTopology(const std::vector<Corners>& triangles, Index vertex_count) {
  check = check_manifold(triangles, vertex_count, &twin);
  if (check.manifold())
    components = connected_components(twin, component);
  else
    twin.clear();
}

}  // namespace filmsticking
