// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/half_edge_repair.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "geometry/corner_angle.h"
#include "geometry/triangle_adjacency.h"
#include "geometry/triangle_circle.h"

namespace filmsticking {
namespace {

// Added to a ring's roughness if all its neighbours have chosen another layer.
constexpr double kCoherence = 2;

class HalfEdgeRepair {
 public:
  HalfEdgeRepair(const HalfEdgeComplex& complex, const std::vector<Vec3>& positions, RingChoice choice,
                 RepairCounts& counts)
      : site_(complex.site),
        twin_(complex.twin),
        point_(complex.point),
        positions_(positions),
        choice_(choice),
        counts_(counts) {}

  std::vector<Corners> run() {
    alive_.assign(site_.size() / 3, 1);
    stamp_.assign(site_.size(), 0);
    find_orbits();
    choose_rings();
    for (Index o = 0; o < static_cast<Index>(out_.size()); ++o) push(o);
    // Ends: only operations push orbits, and the number of operations is bounded (see the header).
    while (!queue_.empty()) {
      // Batch by batch: the order depends on the input alone.
      std::vector<Index> batch;
      batch.swap(queue_);
      for (Index o : batch) {
        queued_[o] = 0;
        process(o);
      }
    }
    std::vector<Corners> triangles;
    for (std::size_t t = 0; t < alive_.size(); ++t)
      if (alive_[t]) triangles.push_back({site_[3 * t], site_[3 * t + 1], site_[3 * t + 2]});
    return triangles;
  }

 private:
  const Vec3& at(Index orbit) const { return positions_[orbit_site_[orbit]]; }
  // All half-edges are paired at all times, so every loop of rotate() returns to its start.
  Index rotate(Index h) const { return twin_[prev_in_face(h)]; }
  Index target(Index h) const { return orbit_[next_in_face(h)]; }

  void push(Index o) {
    if (!queued_[o]) queued_[o] = 1, queue_.push_back(o);
  }

  Index new_orbit(Index site, Index half_edge) {
    const Index o = static_cast<Index>(out_.size());
    out_.push_back(half_edge);
    orbit_site_.push_back(site);
    queued_.push_back(0);
    surplus_.push_back(0);
    affected_.push_back(0);
    orbits_of_site_[site].push_back(o);
    return o;
  }

  void find_orbits() {
    orbit_.assign(site_.size(), kNone);
    orbits_of_site_.assign(positions_.size(), {});
    for (Index h = 0; h < static_cast<Index>(site_.size()); ++h) {
      if (orbit_[h] != kNone) continue;
      const Index o = new_orbit(site_[h], h);
      Index g = h;
      do orbit_[g] = o, g = rotate(g);
      while (g != h);
    }
  }

  // Chooses the ring of every site that has several, the clearest choice first. Where two layers of the film
  // share their sites, their rings are equally smooth, and independent choices would mix the layers. So each
  // neighbour that has chosen the other layer adds to a ring's cost.
  void choose_rings() {
    std::vector<double> cost(out_.size(), 0), against(out_.size(), 0);
    std::vector<char> undecided(orbits_of_site_.size(), 0);
    // The ring of least cost, and its lead over the next.
    const auto best_of = [&](Index site) {
      Index best = kNone;
      double least = std::numeric_limits<double>::infinity(), second = least;
      for (Index o : orbits_of_site_[site]) {
        const double c = cost[o] + against[o];
        if (c < least)
          second = least, least = c, best = o;
        else
          second = std::min(second, c);
      }
      return std::pair(second - least, best);
    };
    std::vector<Index> degree(out_.size(), 0);
    for (const Index o : orbit_) ++degree[o];
    std::priority_queue<std::pair<double, Index>> queue;  // lead, -site: ties by the lower site
    for (std::size_t s = 0; s < orbits_of_site_.size(); ++s) {
      if (orbits_of_site_[s].size() < 2) continue;
      for (Index o : orbits_of_site_[s]) cost[o] = std::min(ring_cost(o), 1e3);
      undecided[s] = 1;
      queue.emplace(best_of(static_cast<Index>(s)).first, -static_cast<Index>(s));
    }
    // Ends: each turn decides a site or updates an entry, which stays valid until the next decision. Costs
    // are finite, so a lead equals itself.
    while (!queue.empty()) {
      const auto [lead, negative] = queue.top();
      const Index site = -negative;
      queue.pop();
      if (!undecided[site]) continue;
      const auto [now, best] = best_of(site);
      if (now !=
          lead) {  // a neighbour chose in the meantime; every choice causes at most its neighbours' turns
        queue.emplace(now, negative);
        continue;
      }
      undecided[site] = 0;
      for (Index o : orbits_of_site_[site]) {
        surplus_[o] = o != best;
        if (o == best) continue;
        // The removed ring's neighbours lose a part of theirs.
        Index h = out_[o];
        do {
          const Index p = target(h);
          against[p] += kCoherence / static_cast<double>(degree[p]);
          h = rotate(h);
        } while (h != out_[o]);
      }
    }
  }

  double ring_cost(Index o) {
    ring_.clear();
    Index h = out_[o];
    if (choice_ == RingChoice::Nearest) {
      double nearest = std::numeric_limits<double>::infinity();
      do nearest = std::min(nearest, (at(o) - point_[h / 3]).squaredNorm()), h = rotate(h);
      while (h != out_[o]);
      return nearest;
    }
    do ring_.push_back(at(target(h))), h = rotate(h);
    while (h != out_[o]);
    return ring_.size() < 3 ? std::numeric_limits<double>::max() : ring_roughness(at(o), ring_);
  }

  // Marks all but the best of a site's orbits as surplus.
  void choose_ring(Index site) {
    auto& orbits = orbits_of_site_[site];
    orbits.erase(std::remove_if(orbits.begin(), orbits.end(), [&](Index o) { return out_[o] == kNone; }),
                 orbits.end());
    Index best = kNone;
    double least = std::numeric_limits<double>::infinity();
    for (Index o : orbits) {
      const double cost = ring_cost(o);
      if (best == kNone || cost < least) least = cost, best = o;
    }
    for (Index o : orbits) surplus_[o] = o != best;
  }

  void process(Index o) {
    if (out_[o] == kNone) return;
    neighbours_.clear();
    Index h = out_[o];
    do neighbours_.push_back({target(h), h}), h = rotate(h);
    while (h != out_[o]);
    if (surplus_[o]) {
      ++counts_.surplus_regions;
      return remove_orbit(o);
    }
    if (neighbours_.size() < 3) {
      ++counts_.thin_regions;
      return remove_orbit(o);
    }
    std::sort(neighbours_.begin(), neighbours_.end());
    for (std::size_t k = 1; k < neighbours_.size(); ++k)
      if (neighbours_[k].first == neighbours_[k - 1].first)
        return resolve_double_edge(neighbours_[k - 1].second, neighbours_[k].second);
  }

  bool joined(Index a, Index b) const {
    Index h = out_[a];
    do {
      if (target(h) == b) return true;
      h = rotate(h);
    } while (h != out_[a]);
    return false;
  }

  // Two edges g and h from the same orbit to the same orbit.
  void resolve_double_edge(Index g, Index h) {
    const Index a = orbit_[g], b = target(g);
    push(a), push(b);
    Index flip = kNone;
    double least = std::numeric_limits<double>::infinity();
    for (Index e : {g, h}) {
      const Index c = orbit_[prev_in_face(e)], d = orbit_[prev_in_face(twin_[e])];
      if (c == d || joined(c, d)) continue;
      const double cost = std::max(circumradius2(at(c), at(d), at(a)), circumradius2(at(c), at(d), at(b)));
      if (flip == kNone || cost < least) least = cost, flip = e;
    }
    if (flip != kNone) {
      ++counts_.flips;
      return flip_edge(flip);
    }
    ++counts_.cuts;
    std::swap(twin_[g], twin_[h]);
    twin_[twin_[g]] = g;
    twin_[twin_[h]] = h;
    relabel({a, b}, {g, h, next_in_face(g), next_in_face(h), twin_[g], twin_[h]});
  }

  // Not flip_edge() and have_edge() of triangle_adjacency.h: here borders may be glued to each other, several
  // edges may join two orbits, and half-edges name orbits, of which a site has several.
  void flip_edge(Index e) {
    // a-b with c on the left and d on the right becomes c-d.
    const Index f = twin_[e];
    const Index e1 = next_in_face(e), e2 = prev_in_face(e), f1 = next_in_face(f), f2 = prev_in_face(f);
    const Index a = orbit_[e], b = orbit_[f], c = orbit_[e2], d = orbit_[f2];
    const Index te1 = twin_[e1], te2 = twin_[e2], tf1 = twin_[f1], tf2 = twin_[f2];
    // Face of e: (d, c, a): d->c, c->a, a->d. Face of f: (c, d, b).
    set_origin(e, d), set_origin(e1, c), set_origin(e2, a);
    set_origin(f, c), set_origin(f1, d), set_origin(f2, b);
    link(e, f);
    // Old borders: e1 was b->c, e2 c->a, f1 a->d, f2 d->b. They may be glued to each other.
    const std::array<std::pair<Index, Index>, 4> moved{{{e1, f2}, {e2, e1}, {f1, e2}, {f2, f1}}};
    const std::array<Index, 4> outside{te1, te2, tf1, tf2};
    for (std::size_t k = 0; k < 4; ++k) {
      Index other = outside[k];
      for (const auto& [from, to] : moved)
        if (other == from) {
          other = to;
          break;
        }
      link(moved[k].second, other);
    }
    out_[a] = e2, out_[b] = f2, out_[c] = f, out_[d] = e;
    push(a), push(b), push(c), push(d);
  }

  void set_origin(Index h, Index orbit) { orbit_[h] = orbit, site_[h] = orbit_site_[orbit]; }
  void link(Index g, Index h) { twin_[g] = h, twin_[h] = g; }

  struct RimEdge {
    Index orbit;  // at which the edge starts
    Index rim;    // number of the edge
  };

  // Removes the star of an orbit and fills the hole. Where the hole's rim touches itself, its parts are
  // filled one by one, which separates the surface there.
  void remove_orbit(Index o) {
    const std::vector<RimEdge> rim = open_star(o);
    for (const std::vector<RimEdge>& part : simple_loops(rim)) fill_part(part);
    glue();

    std::vector<Index> affected, touched;
    for (const RimEdge& r : rim) affected.push_back(r.orbit);
    for (Index i = 0; i < static_cast<Index>(outside_.size()); ++i) {
      if (outside_[i] >= 0) touched.push_back(outside_[i]), touched.push_back(next_in_face(outside_[i]));
      if (inside_[i] >= 0) touched.push_back(inside_[i]), touched.push_back(next_in_face(inside_[i]));
    }
    for (Index f : fresh_)
      for (Index k = 0; k < 3; ++k) touched.push_back(3 * f + k);
    relabel(affected, touched);
  }

  // Removes the triangles around an orbit. Returns the rim of the hole, counter-clockwise: edge i was
  // opposite `o` in its triangle. outside_[i] is the half-edge across it, or -1-j where that is rim edge j.
  // inside_[i] will be the same for the filling.
  std::vector<RimEdge> open_star(Index o) {
    std::vector<RimEdge> rim;
    outside_.clear();
    star_.clear();
    Index h = out_[o];
    do {
      star_.push_back(h / 3);
      rim.push_back({target(h), static_cast<Index>(rim.size())});
      outside_.push_back(next_in_face(h));  // its own half-edge for now
      h = rotate(h);
    } while (h != out_[o]);
    const std::vector<Index> own = outside_;
    for (Index& across : outside_) {
      const Index t = twin_[across];
      const auto glued = std::find(own.begin(), own.end(), t);
      across = glued != own.end() ? -1 - static_cast<Index>(glued - own.begin()) : t;
    }
    for (Index t : star_) alive_[t] = 0;
    out_[o] = kNone;
    inside_.assign(rim.size(), kNone);
    fresh_.clear();
    return rim;
  }

  // A closed walk, divided into loops that meet no orbit twice.
  static std::vector<std::vector<RimEdge>> simple_loops(const std::vector<RimEdge>& rim) {
    std::vector<std::vector<RimEdge>> loops;
    std::vector<RimEdge> walk;
    for (const RimEdge& r : rim) {
      const auto met =
          std::find_if(walk.begin(), walk.end(), [&](const RimEdge& w) { return w.orbit == r.orbit; });
      if (met != walk.end()) {
        loops.emplace_back(met, walk.end());
        walk.erase(met, walk.end());
      }
      walk.push_back(r);
    }
    loops.push_back(std::move(walk));
    return loops;
  }

  // A loop of one edge cannot be: edges join distinct sites' orbits.
  void fill_part(const std::vector<RimEdge>& part) {
    if (part.size() == 1) return;
    if (part.size() == 2) {
      inside_[part[0].rim] = -1 - part[1].rim;
      inside_[part[1].rim] = -1 - part[0].rim;
      return;
    }
    std::vector<Index> orbits, ports;
    for (const RimEdge& r : part) orbits.push_back(r.orbit), ports.push_back(-1 - r.rim);
    fill_polygon(std::move(orbits), std::move(ports));
  }

  // Clips ears of a polygon of distinct orbits, best first. Ears whose chord is an edge already come last.
  void fill_polygon(std::vector<Index> orbits, std::vector<Index> ports) {
    while (orbits.size() > 3) {  // ends: each turn clips an ear
      const std::size_t n = orbits.size();
      // The cheapest ear whose chord is no edge yet. That test is slow, so by rising cost.
      ears_.clear();
      for (std::size_t k = 0; k < n; ++k)
        ears_.emplace_back(circumradius2(at(orbits[k]), at(orbits[(k + 1) % n]), at(orbits[(k + 2) % n])), k);
      std::make_heap(ears_.begin(), ears_.end(), std::greater<>());
      std::size_t best = ears_.front().second;
      while (!ears_.empty()) {
        const std::size_t k = ears_.front().second;
        const Index a = orbits[k], c = orbits[(k + 2) % n];
        if (orbit_site_[a] != orbit_site_[c] && !has_edge(a, c)) {
          best = k;
          break;
        }
        std::pop_heap(ears_.begin(), ears_.end(), std::greater<>());
        ears_.pop_back();
      }
      const std::size_t i = best, j = (best + 1) % n, k = (best + 2) % n;
      const Index h = add_triangle(orbits[i], orbits[j], orbits[k]);
      attach(h, ports[i]);
      attach(h + 1, ports[j]);
      ports[i] = h + 2;  // a half-edge of the filling, to be matched
      orbits.erase(orbits.begin() + static_cast<std::ptrdiff_t>(j));
      ports.erase(ports.begin() + static_cast<std::ptrdiff_t>(j));
    }
    const Index h = add_triangle(orbits[0], orbits[1], orbits[2]);
    for (Index k = 0; k < 3; ++k) attach(h + k, ports[k]);
  }

  // Is there an edge between two orbits outside the hole, or in the filling so far? The ring of an orbit on
  // the rim is open now.
  bool has_edge(Index a, Index c) const {
    for (Index f : fresh_)
      for (Index k = 0; k < 3; ++k) {
        const Index h = 3 * f + k;
        if ((orbit_[h] == a && target(h) == c) || (orbit_[h] == c && target(h) == a)) return true;
      }
    // From each rim edge that starts or ends at a, rotate around a in both directions, up to the hole or to
    // the start.
    for (Index h : outside_) {
      if (h < 0) continue;
      for (Index g : {h, next_in_face(h)}) {
        if (orbit_[g] != a) continue;
        for (Index turn = g;;) {  // counter-clockwise
          if (target(turn) == c || orbit_[prev_in_face(turn)] == c) return true;
          turn = rotate(turn);
          if (turn == g || alive_[turn / 3] != 1) break;
        }
        for (Index turn = g;;) {  // clockwise
          if (target(turn) == c || orbit_[prev_in_face(turn)] == c) return true;
          turn = twin_[turn];
          if (alive_[turn / 3] != 1) break;
          turn = next_in_face(turn);
          if (turn == g) break;
        }
      }
    }
    return false;
  }

  Index add_triangle(Index a, Index b, Index c) {
    // Reuses triangles of the star, which has at least two more than the filling.
    const Index f = star_[fresh_.size()];
    fresh_.push_back(f);
    alive_[f] = 2;  // fresh: not part of the outside while the hole is open
    set_origin(3 * f, a), set_origin(3 * f + 1, b), set_origin(3 * f + 2, c);
    point_[f] = (at(a) + at(b) + at(c)) / 3;
    return 3 * f;
  }

  void attach(Index h, Index port) {
    if (port < 0)
      inside_[-1 - port] = h;
    else
      link(h, port);
  }

  // Links the filling to the outside at every rim edge, through rim edges that are glued to each other.
  void glue() {
    const Index n = static_cast<Index>(outside_.size());
    for (Index i = 0; i < n; ++i)
      for (const bool from_inside : {false, true}) {
        const Index start = from_inside ? inside_[i] : outside_[i];
        if (start < 0) continue;
        Index at_rim = i, other = kNone;
        for (bool inward = !from_inside;; inward = !inward) {
          other = inward ? inside_[at_rim] : outside_[at_rim];
          if (other >= 0) break;
          at_rim = -1 - other;
        }
        link(start, other);
      }
    for (Index f : fresh_) alive_[f] = 1;
  }

  // Updates orbits after an operation: each of `affected` may be divided into several, or be gone. `touched`
  // holds a half-edge of each part.
  void relabel(const std::vector<Index>& affected, const std::vector<Index>& touched) {
    ++time_;
    for (Index o : affected) out_[o] = kNone, affected_[o] = time_;
    std::vector<Index> split;
    for (Index h : touched) {
      const Index o = orbit_[h];
      if (stamp_[h] == time_ || affected_[o] != time_) continue;
      Index label = o;
      if (out_[o] == kNone) {
        out_[o] = h;
      } else {
        label = new_orbit(orbit_site_[o], h);
        split.push_back(orbit_site_[o]);
      }
      Index g = h;
      do {
        stamp_[g] = time_;
        orbit_[g] = label;
        g = rotate(g);
      } while (g != h);
      push(label);
    }
    for (Index s : split) {
      choose_ring(s);
      for (Index o : orbits_of_site_[s])
        if (out_[o] != kNone) push(o);
    }
  }

  std::vector<Index> site_, twin_, orbit_;  // per half-edge
  std::vector<Vec3> point_;                 // per triangle: where its three cells meet
  std::vector<char> alive_;                 // per triangle
  std::vector<Index> out_, orbit_site_;     // per orbit: a half-edge from it (kNone: gone), its site
  std::vector<char> queued_, surplus_;      // per orbit
  std::vector<std::vector<Index>> orbits_of_site_;
  std::vector<Index> queue_;
  std::vector<std::int64_t> stamp_, affected_;  // per half-edge, per orbit: when relabel() last met it
  std::int64_t time_ = 0;
  const std::vector<Vec3>& positions_;
  RingChoice choice_;
  RepairCounts& counts_;
  // Scratch of one operation.
  std::vector<std::pair<Index, Index>> neighbours_;
  std::vector<Index> outside_, inside_, star_, fresh_;
  std::vector<Vec3> ring_;
  std::vector<std::pair<double, std::size_t>> ears_;
};

}  // namespace

double ring_roughness(const Vec3& centre, const std::vector<Vec3>& ring) {
  std::vector<Vec3> normals(ring.size());
  std::vector<double> angles(ring.size());
  Vec3 mean = Vec3::Zero();
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Vec3 &p = ring[k], &q = ring[(k + 1) % ring.size()];
    normals[k] = (p - centre).cross(q - centre).normalized();
    angles[k] = corner_angle(centre, p, q);
    mean += angles[k] * normals[k];
  }
  if (mean.squaredNorm() > 0) mean.normalize();
  double sum = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) sum += angles[k] * (normals[k] - mean).squaredNorm();
  return sum;
}

std::vector<Corners> repair_half_edges(const HalfEdgeComplex& complex, const std::vector<Vec3>& positions,
                                       RingChoice choice, RepairCounts& counts) {
  return HalfEdgeRepair(complex, positions, choice, counts).run();
}

}  // namespace filmsticking
