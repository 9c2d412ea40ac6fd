// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/insert_sites.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/corner_angle.h"
#include "geometry/nearest.h"
#include "geometry/parallel.h"
#include "geometry/triangle_adjacency.h"

namespace filmsticking {
namespace {

class Inserter {
 public:
  explicit Inserter(Surface& film)
      : film_(film), twin_(half_edge_twins(film.triangles, static_cast<Index>(film.positions.size()))) {}

  bool insert(Index face, const Vec3& q, Index site, double reach) {
    const Corners t = film_.triangles[face];
    const Vec3 &a = at(t[0]), &b = at(t[1]), &c = at(t[2]);
    const Vec3 normal = (b - a).cross(c - a);
    const double longest2 = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    const double nearest2 = std::min({(q - a).squaredNorm(), (q - b).squaredNorm(), (q - c).squaredNorm()});
    if (nearest2 > reach * reach * longest2) return false;
    int backs = 0;
    for (int k = 0; k < 3; ++k)
      if ((at(t[(k + 1) % 3]) - at(t[k])).cross(q - at(t[k])).dot(normal) <= 0) ++backs;
    // One inverted face is beyond an edge and is flipped away below. More mean that this is the wrong face.
    if (backs > 1) return false;
    const Index v = static_cast<Index>(film_.positions.size());
    film_.positions.push_back(q);
    film_.site.push_back(site);
    const Index f1 = static_cast<Index>(film_.triangles.size()), f2 = f1 + 1;
    const Index o1 = twin_[3 * face + 1], o2 = twin_[3 * face + 2];
    film_.triangles[face] = {t[0], t[1], v};
    film_.triangles.push_back({t[1], t[2], v});
    film_.triangles.push_back({t[2], t[0], v});
    twin_.resize(twin_.size() + 6);
    link(3 * f1, o1), link(3 * f2, o2);
    link(3 * face + 1, 3 * f1 + 2), link(3 * f1 + 1, 3 * f2 + 2), link(3 * f2 + 1, 3 * face + 2);
    queue_ = {3 * face, 3 * f1, 3 * f2};
    improve();
    return true;
  }

 private:
  const Vec3& at(Index v) const { return film_.positions[v]; }
  Index from(Index h) const { return film_.triangles[h / 3][h % 3]; }
  void link(Index g, Index h) { twin_[g] = h, twin_[h] = g; }

  static Vec3 unit_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 n = (b - a).cross(c - a);
    const double l = n.norm();
    return l > 0 ? Vec3(n / l) : Vec3::Zero();
  }

  // How folded a pair of faces is: 1 - cosine, summed over its own edge and the edges to its four neighbours.
  double bend(const Vec3& n1, const Vec3& n2, const std::array<Vec3, 4>& around, bool flipped) const {
    // around: the faces across bc, ca (of abc) and ad, db (of bad).
    const Vec3 &bc = around[0], &ca = around[1], &ad = around[2], &db = around[3];
    double sum = 1 - n1.dot(n2);
    if (!flipped)
      sum += 4 - n1.dot(bc) - n1.dot(ca) - n2.dot(ad) - n2.dot(db);
    else
      sum += 4 - n1.dot(ca) - n1.dot(ad) - n2.dot(bc) - n2.dot(db);
    return sum;
  }

  Vec3 face_normal(Index f) const {
    const Corners& t = film_.triangles[f];
    return unit_normal(at(t[0]), at(t[1]), at(t[2]));
  }

  void improve() {
    // Every flip lowers the price of its pair. The bound on flips guards against rounding.
    for (int flips = 0; !queue_.empty() && flips < 64;) {
      const Index h = queue_.back(), g = twin_[h];
      queue_.pop_back();
      const Index ia = from(h), ib = from(g), ic = from(prev_in_face(h)), id = from(prev_in_face(g));
      if (ic == id) continue;
      const Vec3 &a = at(ia), &b = at(ib), &c = at(ic), &d = at(id);
      const std::array<Vec3, 4> around{
          face_normal(twin_[next_in_face(h)] / 3), face_normal(twin_[prev_in_face(h)] / 3),
          face_normal(twin_[next_in_face(g)] / 3), face_normal(twin_[prev_in_face(g)] / 3)};
      const double before = price(corner_angle(c, a, b) + corner_angle(d, a, b),
                                  bend(unit_normal(a, b, c), unit_normal(b, a, d), around, false));
      const double after = price(corner_angle(a, c, d) + corner_angle(b, c, d),
                                 bend(unit_normal(a, d, c), unit_normal(b, c, d), around, true));
      if (!(after < before - 1e-9) || have_edge(film_.triangles, twin_, prev_in_face(h), prev_in_face(g)))
        continue;
      flip_edge(film_.triangles, twin_, h);
      ++flips;
      for (Index e : {next_in_face(h), prev_in_face(h), next_in_face(g), prev_in_face(g)})
        queue_.push_back(e);
    }
    queue_.clear();
  }

  // `opposite`: the sum of the angles opposite the edge, below pi if the edge is Delaunay.
  static double price(double opposite, double bend) { return opposite / M_PI + bend; }

  Surface& film_;
  std::vector<Index> twin_;
  std::vector<Index> queue_;
};

}  // namespace

std::int64_t insert_sites(Surface& film, const std::vector<Vec3>& sites, const std::vector<Index>& off,
                          double reach) {
  std::int64_t inserted = 0;
  std::vector<Index> waiting = off;
  Inserter inserter(film);
  // A pass inserts at most one site into each face, the nearest first. The next pass finds the nearest faces
  // of the changed mesh. Ends: a pass inserts a site or is the last.
  while (!waiting.empty()) {
    const SurfaceTree tree(film);
    struct Candidate {
      double distance2;
      Index site, face;
    };
    std::vector<Candidate> candidates(waiting.size());
    parallel_each(waiting.size(), [&](std::size_t k) {
      const SurfaceTree::Hit hit = tree.nearest(sites[waiting[k]]);
      candidates[k] = {(hit.point - sites[waiting[k]]).squaredNorm(), waiting[k], hit.triangle};
    });
    std::sort(candidates.begin(), candidates.end(), [](const Candidate& x, const Candidate& y) {
      return x.distance2 != y.distance2 ? x.distance2 < y.distance2 : x.site < y.site;
    });
    const std::vector<Corners> before = film.triangles;
    std::int64_t now = 0;
    waiting.clear();
    for (const Candidate& c : candidates) {
      if (film.triangles[c.face] != before[c.face] || !inserter.insert(c.face, sites[c.site], c.site, reach))
        waiting.push_back(c.site);
      else
        ++now;
    }
    inserted += now;
    if (now == 0) break;
  }
  return inserted;
}

}  // namespace filmsticking
