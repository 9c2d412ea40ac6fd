// SPDX-License-Identifier: GPL-3.0-or-later
#include "triangle_adjacency.h"

#include <algorithm>

namespace filmsticking {
namespace {

// Half-edges bucketed by their origin.
struct OutgoingHalfEdges {
  std::vector<Index> offset, half_edge;
  OutgoingHalfEdges(const std::vector<Corners>& triangles, Index vertex_count)
      : offset(vertex_count + 1, 0), half_edge(triangles.size() * 3) {
    for (const Corners& t : triangles)
      for (Index v : t) ++offset[v + 1];
    for (std::size_t v = 1; v < offset.size(); ++v) offset[v] += offset[v - 1];
    std::vector<Index> fill(offset.begin(), offset.end() - 1);
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) half_edge[fill[triangles[t][k]]++] = static_cast<Index>(3 * t + k);
  }
};

Index target(const std::vector<Corners>& triangles, Index h) { return triangles[h / 3][next_in_face(h) % 3]; }

}  // namespace

std::vector<Index> half_edge_twins(const std::vector<Corners>& triangles, Index vertex_count) {
  const OutgoingHalfEdges out(triangles, vertex_count);
  std::vector<Index> twin(triangles.size() * 3, kNone);
  for (Index h = 0; h < static_cast<Index>(twin.size()); ++h) {
    const Index a = triangles[h / 3][h % 3], b = target(triangles, h);
    Index found = kNone, count = 0, same = 0;
    for (Index k = out.offset[b]; k < out.offset[b + 1]; ++k)
      if (target(triangles, out.half_edge[k]) == a) found = out.half_edge[k], ++count;
    for (Index k = out.offset[a]; k < out.offset[a + 1]; ++k)
      if (target(triangles, out.half_edge[k]) == b) ++same;
    if (count == 1 && same == 1) twin[h] = found;
  }
  return twin;
}

ManifoldCheck check_manifold(const std::vector<Corners>& triangles, Index vertex_count) {
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
  // Undirected edges, sorted: each must appear once in each direction.
  struct Edge {
    Index a, b;
    bool forward;
  };
  std::vector<Edge> edges;
  edges.reserve(triangles.size() * 3);
  for (const Corners& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = t[k], b = t[(k + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), a < b});
    }
  std::sort(edges.begin(), edges.end(), [](const Edge& x, const Edge& y) {
    return x.a != y.a ? x.a < y.a : x.b != y.b ? x.b < y.b : x.forward < y.forward;
  });
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t j = i;
    while (j < edges.size() && edges[j].a == edges[i].a && edges[j].b == edges[i].b) ++j;
    if (j - i == 1)
      ++check.boundary_edges;
    else if (j - i > 2)
      check.edges_simple = false;
    else if (edges[i].forward == edges[i + 1].forward)
      check.oriented = false;
    i = j;
  }
  check.closed = check.edges_simple && check.boundary_edges == 0;
  if (!check.edges_simple || !check.oriented) {
    check.single_rings = false;
    return check;
  }
  const std::vector<Index> twin = half_edge_twins(triangles, vertex_count);
  std::vector<Index> degree(vertex_count, 0), ring(vertex_count, 0);
  for (const Corners& t : triangles)
    for (Index v : t) ++degree[v];
  for (Index h = 0; h < static_cast<Index>(twin.size()); ++h) {
    const Index v = triangles[h / 3][h % 3];
    if (ring[v] != 0) continue;
    Index first = h;  // where the fan starts, if it is no ring
    while (twin[first] != kNone && next_in_face(twin[first]) != h) first = next_in_face(twin[first]);
    Index g = first;
    do {
      ++ring[v];
      g = twin[prev_in_face(g)];
    } while (g != kNone && g != first);
    if (ring[v] != degree[v]) check.single_rings = false;
  }
  return check;
}

Index connected_components(const std::vector<Index>& twins, std::vector<Index>& component) {
  component.assign(twins.size() / 3, kNone);
  Index count = 0;
  std::vector<Index> stack;
  for (Index seed = 0; seed < static_cast<Index>(component.size()); ++seed) {
    if (component[seed] != kNone) continue;
    component[seed] = count;
    stack.push_back(seed);
    while (!stack.empty()) {
      const Index t = stack.back();
      stack.pop_back();
      for (Index k = 0; k < 3; ++k) {
        if (twins[3 * t + k] == kNone) continue;
        const Index u = twins[3 * t + k] / 3;
        if (component[u] == kNone) component[u] = count, stack.push_back(u);
      }
    }
    ++count;
  }
  return count;
}

}  // namespace filmsticking
