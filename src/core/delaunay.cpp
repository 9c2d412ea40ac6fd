// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

#include "canonical_order.h"
#include "parallel.h"

namespace filmsticking {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

constexpr Index kDead = -2;  // the first corner of a place that holds no tetrahedron
// A round of fewer sites is inserted by one thread. Sites that are taken at a time, and places.
constexpr std::size_t kSmallRound = 20000, kBatch = 1024, kPlaces = 1024, kOften = 256;
// Sites of the first round, about, and the bits that tell a site's round: one in eight is in an earlier one.
constexpr std::size_t kFirstRound = 512;
constexpr int kRoundBits = 3;

struct Tetrahedron {
  std::array<Index, 4> corner, neighbour;
  bool infinite() const {
    return corner[0] == kNone || corner[1] == kNone || corner[2] == kNone || corner[3] == kNone;
  }
  int corner_index(Index v) const { return corner[0] == v ? 0 : corner[1] == v ? 1 : corner[2] == v ? 2 : 3; }
  int neighbour_index(Index t) const {
    return neighbour[0] == t ? 0 : neighbour[1] == t ? 1 : neighbour[2] == t ? 2 : 3;
  }
};

enum class Insertion { Done, Busy, Full, Tie };

/// What one thread needs for its insertions.
struct Worker {
  std::uint8_t id = 0;      // its locks
  std::uint32_t stamp = 0;  // of the insertion at work, which no other worker and no other insertion has
  std::vector<Index> free;  // places, all locked
  struct Facet {
    Index t;
    int k;
    Index made;  // the new tetrahedron on it
  };
  std::vector<Index> cavity, locked;
  std::vector<Facet> border;
  std::vector<Index> busy;  // sites that met a lock
};

class Triangulation {
 public:
  Triangulation(const std::vector<Vec3>& sites, const TriangulationLimits& limits)
      : limits_(limits), at_(new std::atomic<Index>[sites.size()]) {
    points_.reserve(sites.size());
    for (const Vec3& p : sites) points_.emplace_back(p.x(), p.y(), p.z());
    for (std::size_t v = 0; v < sites.size(); ++v) at_[v].store(kNone, std::memory_order_relaxed);
    // More than a surface's sites make; memory that is not touched is not taken.
    grow((8 * sites.size() / kPlaces + 16) * kPlaces);
  }

  bool build() {
    const std::size_t n = points_.size();
    const auto threads = static_cast<std::size_t>(std::max(1, tbb::this_task_arena::max_concurrency()));
    workers_.resize(std::min<std::size_t>({threads, std::max<std::size_t>(1, n / kSmallRound), 64}));
    for (std::size_t w = 0; w < workers_.size(); ++w)
      workers_[w].id = static_cast<std::uint8_t>(w + 1), workers_[w].stamp = static_cast<std::uint32_t>(w);
    if (!first_tetrahedron()) return false;
    int rounds = 1;
    while (rounds < 8 && n >> (kRoundBits * rounds) > kFirstRound) ++rounds;
    std::vector<Index> round;
    for (int level = rounds; level-- > 0;) {
      round.clear();
      for (std::size_t v = 0; v < n; ++v)
        if (level_of(v, rounds - 1) == level && at(v) == kNone) round.push_back(static_cast<Index>(v));
      if (!insert_round(round)) return false;
      watch(1);
    }
    return true;
  }

  Tetrahedra result() {
    const std::size_t used = std::min(used_.load(), capacity_);
    std::vector<Index> place(used);
    Index count = 0;
    for (std::size_t t = 0; t < used; ++t) place[t] = tets_[t].corner[0] == kDead ? kNone : count++;
    Tetrahedra result;
    result.corners.resize(static_cast<std::size_t>(count));
    result.neighbours.resize(static_cast<std::size_t>(count));
    parallel_each(used, [&](std::size_t t) {
      if (place[t] == kNone) return;
      result.corners[place[t]] = tets_[t].corner;
      for (int k = 0; k < 4; ++k) result.neighbours[place[t]][k] = place[tets_[t].neighbour[k]];
    });
    return result;
  }

 private:
  // Who reads a place here may try its lock, so that must have been set before.
  Index at(std::size_t v) const { return at_[v].load(std::memory_order_acquire); }

  // The limits are those of a round's sites, which are the same for any number of threads; what is more than
  // that on the way, with some of them, is not.
  void watch(std::int64_t times) const {
    limits_.cancel();
    if (alive_.load(std::memory_order_relaxed) / times > limits_.tetrahedra) throw TooManyTetrahedra{};
  }

  // Of a site: 0, the last round, mostly. By a hash, so that no order of the sites is a bad one.
  static int level_of(std::size_t v, int most) {
    std::uint64_t h = (v + 1) * 0x9e3779b97f4a7c15ULL;
    h = (h ^ h >> 31) * 0xbf58476d1ce4e5b9ULL;
    h ^= h >> 29;
    int level = 0;
    for (; level < most && h % (1 << kRoundBits) == 0; h >>= kRoundBits) ++level;
    return level;
  }

  CGAL::Sign orientation(const std::array<Index, 4>& c) const {
    return Kernel::Orientation_3()(points_[c[0]], points_[c[1]], points_[c[2]], points_[c[3]]);
  }

  // Positive: the site is in the tetrahedron's sphere, or beyond the hull's facet; zero: on it.
  CGAL::Sign conflict(const Tetrahedron& t, Index p) const {
    const auto& c = t.corner;
    for (int k = 0; k < 4; ++k)
      if (c[k] == kNone) {
        std::array<Index, 4> with = c;
        with[k] = p;
        return orientation(with);
      }
    return Kernel::Side_of_oriented_sphere_3()(points_[c[0]], points_[c[1]], points_[c[2]], points_[c[3]],
                                               points_[p]);
  }

  // `capacity`: whole blocks, so that no place is without an owner.
  void grow(std::size_t capacity) {
    std::unique_ptr<Tetrahedron[]> tets(new Tetrahedron[capacity]);
    std::unique_ptr<std::uint32_t[]> mark(new std::uint32_t[capacity]);
    std::unique_ptr<std::atomic<std::uint8_t>[]> lock(new std::atomic<std::uint8_t>[capacity]);
    for (std::size_t t = 0; t < std::min(used_.load(), capacity_); ++t) {
      tets[t] = tets_[t], mark[t] = mark_[t];
      lock[t].store(lock_[t].load(std::memory_order_relaxed), std::memory_order_relaxed);
    }
    tets_ = std::move(tets), mark_ = std::move(mark), lock_ = std::move(lock);
    used_ = std::min(used_.load(), capacity_);
    capacity_ = capacity;
  }

  // Places for so many tetrahedra. False: there are no more.
  bool reserve(Worker& w, std::size_t count) {
    while (w.free.size() < count) {
      const std::size_t begin = used_.fetch_add(kPlaces);
      if (begin + kPlaces > capacity_) return false;
      for (std::size_t t = begin + kPlaces; t-- > begin;) {
        tets_[t].corner[0] = kDead;
        mark_[t] = 0;
        lock_[t].store(w.id, std::memory_order_relaxed);
        w.free.push_back(static_cast<Index>(t));
      }
    }
    return true;
  }

  // The first of the sites that span space, and the four infinite tetrahedra around it.
  bool first_tetrahedron() {
    const auto n = static_cast<Index>(points_.size());
    if (n < 4) return false;
    std::array<Index, 4> c{0, n / 2, n - 1, kNone};
    for (const Index third : {n - 1, n / 4, n / 4 * 3, Index{1}}) {
      if (third == c[0] || third == c[1]) continue;
      c[2] = third;
      for (Index v = 1; v < n && c[3] == kNone; ++v)
        if (orientation({c[0], c[1], c[2], v}) != CGAL::ZERO) c[3] = v;
      if (c[3] != kNone) break;
    }
    if (c[3] == kNone) return false;
    if (orientation(c) == CGAL::NEGATIVE) std::swap(c[0], c[1]);
    if (!reserve(workers_[0], 5)) return false;
    std::array<Index, 5> id{};
    for (Index& t : id) t = workers_[0].free.back(), workers_[0].free.pop_back();
    alive_ = static_cast<std::int64_t>(id.size());
    for (const Index t : id) lock_[t].store(0, std::memory_order_relaxed);
    tets_[id[4]] = {c, {id[0], id[1], id[2], id[3]}};
    for (int k = 0; k < 4; ++k) {
      // The vertex at infinity in place of corner k is on the other side; swapping two others mends that.
      Tetrahedron& t = tets_[id[k]];
      t.corner = c, t.neighbour = {id[0], id[1], id[2], id[3]};
      t.corner[k] = kNone, t.neighbour[k] = id[4];
      const int i = k == 0 ? 1 : 0, j = k <= 1 ? 2 : 1;
      std::swap(t.corner[i], t.corner[j]), std::swap(t.neighbour[i], t.neighbour[j]);
      at_[c[k]].store(id[4], std::memory_order_relaxed);
    }
    return true;
  }

  bool insert_round(const std::vector<Index>& round) {
    if (workers_.size() < 2 || round.size() < kSmallRound) return insert_alone(round);
    // A worker takes batches of its own part first, far from the others, then helps with the other parts.
    const std::size_t parts = workers_.size(), part = (round.size() + parts - 1) / parts;
    std::vector<std::atomic<std::size_t>> next(parts);
    for (std::size_t i = 0; i < parts; ++i) next[i] = i * part;
    std::atomic<bool> tie{false};
    tbb::parallel_for(std::size_t{0}, parts, [&](std::size_t w) {
      Worker& worker = workers_[w];
      worker.busy.clear();
      for (std::size_t i = 0; i < parts; ++i) {
        const std::size_t own = (w + i) % parts, end = std::min(round.size(), (own + 1) * part);
        for (std::size_t begin; (begin = next[own].fetch_add(kBatch)) < end;)
          for (std::size_t j = begin; j < std::min(end, begin + kBatch); ++j) {
            if (tie.load(std::memory_order_relaxed)) return;
            if (j % kOften == 0) watch(2);
            const Insertion result = insert<true>(worker, round[j]);
            if (result == Insertion::Tie) tie = true;
            if (result == Insertion::Busy || result == Insertion::Full) worker.busy.push_back(round[j]);
          }
      }
    });
    if (tie) return false;
    std::vector<Index> rest;
    for (const Worker& w : workers_) rest.insert(rest.end(), w.busy.begin(), w.busy.end());
    std::sort(rest.begin(), rest.end());
    return insert_alone(rest);
  }

  bool insert_alone(const std::vector<Index>& round) {
    for (std::size_t i = 0; i < round.size(); ++i) {
      const Index p = round[i];
      if (i % kOften == 0) watch(2);
      Insertion result = insert<false>(workers_[0], p);
      // There is room for any site's tetrahedra after some doublings.
      for (; result == Insertion::Full; result = insert<false>(workers_[0], p)) grow(2 * capacity_);
      if (result != Insertion::Done) return false;
    }
    return true;
  }

  template <bool kShared>
  bool acquire(Worker& w, Index t) {
    if (!kShared) return true;
    std::uint8_t none = 0;
    return lock_[t].compare_exchange_strong(none, w.id, std::memory_order_acquire, std::memory_order_relaxed);
  }
  template <bool kShared>
  void release(Index t) {
    if (kShared) lock_[t].store(0, std::memory_order_release);
  }
  template <bool kShared>
  Insertion give_up(Worker& w, Insertion why) {
    if (kShared)
      for (const Index t : w.locked) release<kShared>(t);
    return why;
  }

  // The tetrahedron that holds a site, or an infinite one beyond whose facet it is; locked. kNone: busy.
  template <bool kShared>
  Index locate(Worker& w, Index p) {
    Index hint = p;
    while (hint > 0 && at(hint) == kNone) --hint;
    while (at(hint) == kNone) ++hint;  // four sites are in it
    Index t = at(hint), from = kNone;
    if (!acquire<kShared>(w, t)) return kNone;
    if (tets_[t].corner[0] == kDead) {
      release<kShared>(t);
      return kNone;
    }
    // In a Delaunay triangulation no walk that crosses separating facets comes back: the power of the site to
    // the spheres falls with every step (Edelsbrunner 1989).
    for (bool moved = true; moved;) {
      moved = false;
      const Tetrahedron& now = tets_[t];
      const int infinite = now.infinite() ? now.corner_index(kNone) : -1;
      if (infinite >= 0 && from != kNone) break;  // it came through the facet of the hull
      for (int k = 0; k < 4 && !moved; ++k) {
        const Index next = now.neighbour[k];
        if (infinite >= 0 ? k != infinite : next == from) continue;
        if (infinite < 0) {
          std::array<Index, 4> with = now.corner;
          with[k] = p;
          if (orientation(with) != CGAL::NEGATIVE) continue;
        }
        const bool got = acquire<kShared>(w, next);
        release<kShared>(t);
        if (!got) return kNone;
        from = infinite >= 0 ? kNone : t;
        t = next;
        moved = true;
      }
    }
    return t;
  }

  template <bool kShared>
  Insertion insert(Worker& w, Index p) {
    const Index start = locate<kShared>(w, p);
    if (start == kNone) return Insertion::Busy;
    w.cavity.assign(1, start), w.locked.assign(1, start), w.border.clear();
    w.stamp += static_cast<std::uint32_t>(workers_.size());
    const std::uint32_t in = 2 * w.stamp + 1, out = 2 * w.stamp;
    if (conflict(tets_[start], p) != CGAL::POSITIVE) return give_up<kShared>(w, Insertion::Tie);
    mark_[start] = in;
    for (std::size_t i = 0; i < w.cavity.size(); ++i) {
      const Index t = w.cavity[i];
      for (int k = 0; k < 4; ++k) {
        const Index u = tets_[t].neighbour[k];
        if (kShared && lock_[u].load(std::memory_order_relaxed) != w.id) {
          if (!acquire<kShared>(w, u)) return give_up<kShared>(w, Insertion::Busy);
          w.locked.push_back(u);
        }
        if (mark_[u] == in) continue;
        if (mark_[u] != out) {
          const CGAL::Sign sign = conflict(tets_[u], p);
          if (sign == CGAL::ZERO) return give_up<kShared>(w, Insertion::Tie);
          mark_[u] = sign == CGAL::POSITIVE ? in : out;
          if (sign == CGAL::POSITIVE) {
            w.cavity.push_back(u);
            continue;
          }
        }
        w.border.push_back({t, k, kNone});
      }
    }
    if (!reserve(w, w.border.size())) return give_up<kShared>(w, Insertion::Full);
    fill<kShared>(w, p, in);
    return Insertion::Done;
  }

  // A new tetrahedron on each facet around the cavity.
  template <bool kShared>
  void fill(Worker& w, Index p, std::uint32_t in) {
    for (Worker::Facet& f : w.border) {
      f.made = w.free.back();
      w.free.pop_back();
      Tetrahedron &made = tets_[f.made], &old = tets_[f.t];
      const Index u = old.neighbour[f.k];
      made.corner = old.corner, made.corner[f.k] = p;
      made.neighbour = {kNone, kNone, kNone, kNone}, made.neighbour[f.k] = u;
      tets_[u].neighbour[tets_[u].neighbour_index(f.t)] = f.made;
      old.neighbour[f.k] = f.made;  // for those that look for it around an edge
      mark_[f.made] = 0;
      for (const Index v : made.corner)
        if (v != kNone) at_[v].store(f.made, std::memory_order_release);
      if (kShared) w.locked.push_back(f.made);
    }
    for (const Worker::Facet& f : w.border)
      for (int m = 0; m < 4; ++m) {
        if (m == f.k || tets_[f.made].neighbour[m] != kNone) continue;
        // Around the edge of facets k and m, through the cavity, to the facet around it on the other side.
        Index t = f.t;
        int a = m, b = f.k;  // the corners beside the edge: across a, away from b
        for (Index next; mark_[next = tets_[t].neighbour[a]] == in; t = next) {
          const int came = tets_[next].neighbour_index(t);
          a = tets_[next].corner_index(tets_[t].corner[b]);
          b = came;
        }
        const Index other = tets_[t].neighbour[a];
        tets_[f.made].neighbour[m] = other;
        tets_[other].neighbour[b] = f.made;
      }
    alive_.fetch_add(static_cast<std::int64_t>(w.border.size()) - static_cast<std::int64_t>(w.cavity.size()),
                     std::memory_order_relaxed);
    for (const Index t : w.cavity) {
      tets_[t].corner[0] = kDead;
      mark_[t] = 0;
      w.free.push_back(t);
    }
    if (kShared) {
      // Places that are free stay locked, so that nobody takes a stale hint for a tetrahedron.
      for (const Index t : w.locked)
        if (tets_[t].corner[0] != kDead) release<kShared>(t);
    } else {
      for (const Worker::Facet& f : w.border) lock_[f.made].store(0, std::memory_order_relaxed);
      for (const Index t : w.cavity) lock_[t].store(w.id, std::memory_order_relaxed);
    }
  }

  const TriangulationLimits& limits_;
  std::atomic<std::int64_t> alive_{0};  // tetrahedra
  std::vector<Kernel::Point_3> points_;
  std::unique_ptr<std::atomic<Index>[]> at_;  // a tetrahedron at each site, or kNone: it is not in yet
  std::unique_ptr<Tetrahedron[]> tets_;
  std::unique_ptr<std::uint32_t[]> mark_;              // by the last insertion that met it: in, out
  std::unique_ptr<std::atomic<std::uint8_t>[]> lock_;  // the worker's id; 0: none
  std::atomic<std::size_t> used_{0};
  std::size_t capacity_ = 0;
  std::vector<Worker> workers_;
};

}  // namespace

bool incremental_delaunay(const std::vector<Vec3>& sites, Tetrahedra& tets,
                          const TriangulationLimits& limits) {
  tets = {};
  Triangulation triangulation(sites, limits);
  if (!triangulation.build()) return false;
  tets = triangulation.result();
  return true;
}

Tetrahedra delaunay_tetrahedra(const std::vector<Vec3>& sites, const TriangulationLimits& limits) {
  Tetrahedra tets;
  if (!incremental_delaunay(sites, tets, limits)) {
    const DelaunayTriangulation triangulation(sites, limits);
    if (triangulation.dimension() == 3) tets = triangulation.tetrahedra();
  }
  return in_canonical_order(std::move(tets), sites.size());
}

PowerDiagram voronoi_diagram(const Tetrahedra& tets, const std::vector<Vec3>& sites) {
  PowerDiagram diagram;
  diagram.position = sites;
  // Both ways of every edge, once for each of its tetrahedra, by their first site.
  std::vector<Index> offset(sites.size() + 1, 0), all;
  const auto each_pair = [&](const auto& pair) {
    for (const auto& c : tets.corners)
      for (const Index a : c)
        for (const Index b : c)
          if (a != kNone && b != kNone && a != b) pair(a, b);
  };
  each_pair([&](Index a, Index) { ++offset[a + 1]; });
  for (std::size_t i = 1; i < offset.size(); ++i) offset[i] += offset[i - 1];
  all.resize(static_cast<std::size_t>(offset.back()));
  std::vector<Index> end(offset.begin(), offset.end() - 1);
  each_pair([&](Index a, Index b) { all[end[a]++] = b; });
  parallel_each(sites.size(), [&](std::size_t i) {
    std::sort(all.begin() + offset[i], all.begin() + end[i]);
    end[i] = static_cast<Index>(std::unique(all.begin() + offset[i], all.begin() + end[i]) - all.begin());
  });
  diagram.offset.assign(1, 0);
  for (std::size_t i = 0; i < sites.size(); ++i) {
    diagram.neighbour.insert(diagram.neighbour.end(), all.begin() + offset[i], all.begin() + end[i]);
    diagram.offset.push_back(static_cast<Index>(diagram.neighbour.size()));
    if (diagram.any_site == kNone && diagram.has_cell(static_cast<Index>(i)))
      diagram.any_site = static_cast<Index>(i);
  }
  return diagram;
}

}  // namespace filmsticking
