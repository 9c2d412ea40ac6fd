// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/nearest.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <numeric>

namespace filmsticking {

// A kd-tree, split at the median along the widest side. Results do not depend on the tree: of points at the
// same distance the one of the lower number is nearer.
struct PointTree::Impl {
  struct Node {
    Vec3 lo, hi;
    Index begin, end, left, right;  // left == kNone: a leaf
  };
  static constexpr Index kLeaf = 8;      // most points in a leaf
  static constexpr Index kAlone = 4096;  // most points of a subtree built by one thread

  std::vector<Index> id;
  const std::vector<Vec3>& points;
  std::vector<Node> nodes;
  std::atomic<Index> used{0};

  explicit Impl(const std::vector<Vec3>& p)
      : id(p.size()), points(p), nodes(p.empty() ? 0 : p.size() / 2 + 1) {
    std::iota(id.begin(), id.end(), 0);
    if (!id.empty()) build(p, 0, static_cast<Index>(id.size()));
  }

  Index build(const std::vector<Vec3>& p, Index begin, Index end) {
    const Index n = used++;
    Node& node = nodes[n];
    node = {p[id[begin]], p[id[begin]], begin, end, kNone, kNone};
    for (Index i = begin; i < end; ++i) {
      node.lo = node.lo.cwiseMin(p[id[i]]);
      node.hi = node.hi.cwiseMax(p[id[i]]);
    }
    if (end - begin <= kLeaf) return n;
    Index axis;
    (node.hi - node.lo).maxCoeff(&axis);
    const Index middle = begin + (end - begin) / 2;
    // Not median(): the halves must be parted at the middle, ties by number.
    std::nth_element(id.begin() + begin, id.begin() + middle, id.begin() + end, [&](Index a, Index b) {
      return p[a][axis] != p[b][axis] ? p[a][axis] < p[b][axis] : a < b;
    });
    const auto left = [&] { node.left = build(p, begin, middle); };
    const auto right = [&] { node.right = build(p, middle, end); };
    if (end - begin > kAlone)
      tbb::parallel_invoke(left, right);
    else
      left(), right();
    return n;
  }

  double box_distance2(Index n, const Vec3& x) const {
    return (nodes[n].lo - x).cwiseMax(x - nodes[n].hi).cwiseMax(0).squaredNorm();
  }

  // `found`: a heap of the k nearest so far, the farthest on top.
  using Found = std::vector<std::pair<double, Index>>;
  void search(Index n, const Vec3& x, std::size_t k, Found& found) const {
    const Node& node = nodes[n];
    if (node.left == kNone) {
      for (Index i = node.begin; i < node.end; ++i) {
        const std::pair<double, Index> candidate{(points[id[i]] - x).squaredNorm(), id[i]};
        if (found.size() == k && !(candidate < found.front())) continue;
        if (found.size() == k) std::pop_heap(found.begin(), found.end()), found.pop_back();
        found.push_back(candidate), std::push_heap(found.begin(), found.end());
      }
      return;
    }
    Index near = node.left, far = node.right;
    double dn = box_distance2(near, x), df = box_distance2(far, x);
    if (df < dn) std::swap(near, far), std::swap(dn, df);
    if (found.size() < k || dn <= found.front().first) search(near, x, k, found);
    if (found.size() < k || df <= found.front().first) search(far, x, k, found);
  }
};

PointTree::PointTree(const std::vector<Vec3>& points) : impl_(new Impl(points)) {}
PointTree::~PointTree() = default;

Index PointTree::nearest(const Vec3& x, double* distance2) const {
  if (impl_->nodes.empty()) return kNone;
  Impl::Found found;
  impl_->search(0, x, 1, found);
  if (distance2 != nullptr) *distance2 = found.front().first;
  return found.front().second;
}

std::vector<Index> PointTree::nearest(const Vec3& x, std::size_t k) const {
  std::vector<Index> ids;
  if (impl_->nodes.empty() || k == 0) return ids;
  Impl::Found found;
  found.reserve(std::min(k, impl_->points.size()));
  impl_->search(0, x, k, found);
  ids.reserve(found.size());
  std::sort(found.begin(), found.end());
  for (const auto& f : found) ids.push_back(f.second);
  return ids;
}

namespace {
using Kernel = CGAL::Simple_cartesian<double>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, std::vector<Kernel::Triangle_3>::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
Kernel::Point_3 cgal_point(const Vec3& p) { return {p.x(), p.y(), p.z()}; }
}  // namespace

struct SurfaceTree::Impl {
  std::vector<Kernel::Triangle_3> triangles;
  Tree tree;
};

SurfaceTree::SurfaceTree(const Surface& surface) : impl_(new Impl) {
  for (const Corners& t : surface.triangles)
    impl_->triangles.emplace_back(cgal_point(surface.positions[t[0]]), cgal_point(surface.positions[t[1]]),
                                  cgal_point(surface.positions[t[2]]));
  impl_->tree.insert(impl_->triangles.cbegin(), impl_->triangles.cend());
  impl_->tree.build();
  // Not at the first query: several threads query.
  impl_->tree.accelerate_distance_queries();
}
SurfaceTree::~SurfaceTree() = default;

SurfaceTree::Hit SurfaceTree::nearest(const Vec3& x) const {
  const auto hit = impl_->tree.closest_point_and_primitive(cgal_point(x));
  return {Vec3(hit.first.x(), hit.first.y(), hit.first.z()),
          static_cast<Index>(hit.second - impl_->triangles.cbegin())};
}

}  // namespace filmsticking
