// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay/delaunay.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>

#include "delaunay/canonical_order.h"
#include "delaunay/regular.h"
#include "delaunay/tetrahedral_mesh.h"
#include "geometry/parallel.h"

namespace filmsticking {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

constexpr Index kDead = -2;  // first corner of a slot that holds no tetrahedron
// One thread inserts a round of fewer than kSmallRound sites. Threads take kBatch sites and kPlaces slots at
// a time. Every kOften sites they check the limits.
constexpr std::size_t kSmallRound = 20000, kBatch = 1024, kPlaces = 1024, kOften = 256;
// The first round has about kFirstRound sites. One site in 2^kRoundBits belongs to an earlier round.
constexpr std::size_t kFirstRound = 512;
constexpr int kRoundBits = 3;

// Fills one cache line.
struct alignas(64) Tetrahedron {
  std::array<Index, 4> corner, neighbour;
  // The circumsphere's rounded centre. A site at a squared distance below `in` is surely in the sphere, above
  // `out` surely outside.
  std::array<float, 3> centre;
  float in, out;
  std::uint32_t mark;              // set by the last insertion that visited it: in or out of its cavity
  std::atomic<std::uint8_t> lock;  // the owning worker's id, or 0

  void copy(const Tetrahedron& t) {
    corner = t.corner, neighbour = t.neighbour, centre = t.centre, in = t.in, out = t.out, mark = t.mark;
    lock.store(t.lock.load(std::memory_order_relaxed), std::memory_order_relaxed);
  }
  bool infinite() const {
    return corner[0] == kNone || corner[1] == kNone || corner[2] == kNone || corner[3] == kNone;
  }
  int corner_index(Index v) const { return corner[0] == v ? 0 : corner[1] == v ? 1 : corner[2] == v ? 2 : 3; }
  int neighbour_index(Index t) const {
    return neighbour[0] == t ? 0 : neighbour[1] == t ? 1 : neighbour[2] == t ? 2 : 3;
  }
};

enum class Insertion { Done, Busy, Full, Tie };

/// Scratch of one thread.
struct Worker {
  std::uint8_t id = 0;      // marks its locks
  std::uint32_t stamp = 0;  // number of the current insertion, unique among all workers
  std::vector<Index> free;  // empty slots, all locked
  struct Facet {
    Index t;
    int k;
    Index made;  // the new tetrahedron on this facet
  };
  struct Edge {
    std::uint64_t sites;
    Index made;
    int k;
    std::uint32_t of;  // the insertion that wrote it
  };
  std::vector<Index> cavity, locked;
  std::vector<Facet> border;
  // For a cavity with few facets, whose sites get short names: names by site, sites by name, the named
  // corners of each facet, and the new tetrahedron on the facet to the left of each named edge.
  static constexpr std::size_t kFewFacets = 120, kFewSites = kFewFacets / 2 + 2;
  std::vector<std::uint8_t> name;
  std::array<Index, kFewSites> named;
  std::array<std::array<std::uint8_t, 3>, kFewFacets> ends;
  std::array<std::array<Index, kFewSites + 2>, kFewSites> beside;
  // For a cavity with many facets.
  std::vector<Edge> edges;      // a hash table
  std::uint32_t insertion = 0;  // the last that used the table
  std::vector<Index> busy;      // sites that met a lock
};

class Triangulation {
 public:
  Triangulation(const std::vector<Vec3>& sites, const TriangulationLimits& limits)
      : limits_(limits), sites_(sites), at_(new std::atomic<Index>[sites.size()]) {
    for (std::size_t v = 0; v < sites.size(); ++v) at_[v].store(kNone, std::memory_order_relaxed);
    // More than a surface's sites make. The system gives only the memory that is touched.
    grow((8 * sites.size() / kPlaces + 16) * kPlaces);
  }

  bool build() {
    const std::size_t n = sites_.size();
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
    UnsetVector<Index> place(used);
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
  // Acquire: whoever reads a slot here may try its lock, which must be set before.
  Index at(std::size_t v) const { return at_[v].load(std::memory_order_acquire); }

  // The limit at the end of a round does not depend on the number of threads. Within a round the order of
  // insertion does, so the caller allows `times` as many there.
  void watch(std::int64_t times) const {
    limits_.cancel();
    if (alive_.load(std::memory_order_relaxed) / times > limits_.tetrahedra) throw TooManyTetrahedra{};
  }

  // A site's round, counted from the last: 0 for most sites. A hash decides, so that no order is bad.
  static int level_of(std::size_t v, int most) {
    std::uint64_t h = (v + 1) * 0x9e3779b97f4a7c15ULL;
    h = (h ^ h >> 31) * 0xbf58476d1ce4e5b9ULL;
    h ^= h >> 29;
    int level = 0;
    for (; level < most && h % (1 << kRoundBits) == 0; h >>= kRoundBits) ++level;
    return level;
  }

  Kernel::Point_3 point(Index v) const { return {sites_[v].x(), sites_[v].y(), sites_[v].z()}; }

  CGAL::Sign orientation(const std::array<Index, 4>& c) const {
    return Kernel::Orientation_3()(point(c[0]), point(c[1]), point(c[2]), point(c[3]));
  }

  // Sets the bounds that decide quickly whether a site is in the sphere. `k`: a corner that is a site.
  //
  // Let u, v and w be the vectors from that corner a to the others, and m the longest of them. The centre is
  // a + N / D with D = 2 u (v x w) and N = u^2 v x w + v^2 w x u + w^2 u x v. Rounding errs by less than
  // 62 epsilon m^4 in N and 28 epsilon m^3 in D (counted as in Higham, "Accuracy and stability of numerical
  // algorithms", 2002), and m is at most twice the radius r. Let this and the rounding to float move the
  // centre c by e. Then the power |p - c|^2 - |a - c|^2 of a site p errs by at most 2 |p - a| e. Within 2 r
  // of the centre that is at most 6 r e. Farther away it cannot change the sign if e is small compared with
  // r.
  void set_sphere(Tetrahedron& t, int k) const {
    t.in = 0, t.out = std::numeric_limits<float>::infinity();
    t.centre = {0, 0, 0};
    if (t.infinite()) return;
    constexpr double kEpsilon = std::numeric_limits<double>::epsilon() / 2;
    const Vec3& a = sites_[t.corner[k]];
    const Vec3 u = sites_[t.corner[k ^ 1]] - a, v = sites_[t.corner[k ^ 2]] - a,
               w = sites_[t.corner[k ^ 3]] - a;
    const Vec3 vw = v.cross(w);
    const double d = 2 * u.dot(vw), uu = u.squaredNorm(), vv = v.squaredNorm(), ww = w.squaredNorm();
    const double over_d = 1 / d;
    const Vec3 c = (uu * vw + vv * w.cross(u) + ww * u.cross(v)) * over_d;
    const double mm = std::max({uu, vv, ww}), radius = c.norm();
    const double error_n = 192 * kEpsilon * mm * mm, error_d = 300 * kEpsilon * mm * radius;
    const Vec3 centre = a + c;
    const double e = (error_n + 4 * radius * error_d) * std::abs(over_d) + 8 * kEpsilon * radius +
                     6.5e-8 * centre.lpNorm<1>() + 1e-30;
    if (!(std::abs(d) > 4 * error_d && 5 * radius * radius > mm && 10 * e < radius && radius > 1e-15 &&
          radius < 1e15))
      return;
    t.centre = {static_cast<float>(centre.x()), static_cast<float>(centre.y()),
                static_cast<float>(centre.z())};
    const double rr = squared_distance(t, a), slack = 6.1 * (radius + e) * e + 1e-14 * rr;
    t.in = static_cast<float>(std::max(0.0, rr - slack) * (1 - 1e-6));
    t.out = static_cast<float>((rr + slack) * (1 + 1e-6));
  }

  static double squared_distance(const Tetrahedron& t, const Vec3& p) {
    const double x = p.x() - double{t.centre[0]}, y = p.y() - double{t.centre[1]},
                 z = p.z() - double{t.centre[2]};
    return x * x + y * y + z * z;
  }

  // Positive if the site is in the tetrahedron's sphere or beyond the hull facet; zero if it is on it.
  CGAL::Sign conflict(const Tetrahedron& t, Index p) const {
    const double dd = squared_distance(t, sites_[p]);
    return dd < t.in ? CGAL::POSITIVE : dd > t.out ? CGAL::NEGATIVE : exact_conflict(t, p);
  }

  CGAL::Sign exact_conflict(const Tetrahedron& t, Index p) const {
    const auto& c = t.corner;
    for (int k = 0; k < 4; ++k)
      if (c[k] == kNone) {
        std::array<Index, 4> with = c;
        with[k] = p;
        return orientation(with);
      }
    return Kernel::Side_of_oriented_sphere_3()(point(c[0]), point(c[1]), point(c[2]), point(c[3]), point(p));
  }

  // `capacity`: a multiple of kPlaces, so that every slot has an owner.
  void grow(std::size_t capacity) {
    std::unique_ptr<Tetrahedron[]> tets(new Tetrahedron[capacity]);
    for (std::size_t t = 0; t < std::min(used_.load(), capacity_); ++t) tets[t].copy(tets_[t]);
    tets_ = std::move(tets);
    used_ = std::min(used_.load(), capacity_);
    capacity_ = capacity;
  }

  // Reserves `count` slots. False if there are no more.
  bool reserve(Worker& w, std::size_t count) {
    while (w.free.size() < count) {
      const std::size_t begin = used_.fetch_add(kPlaces);
      if (begin + kPlaces > capacity_) return false;
      for (std::size_t t = begin + kPlaces; t-- > begin;) {
        tets_[t].corner[0] = kDead;
        tets_[t].mark = 0;
        tets_[t].lock.store(w.id, std::memory_order_relaxed);
        w.free.push_back(static_cast<Index>(t));
      }
    }
    return true;
  }

  // Makes a tetrahedron of four sites that span space, and the four infinite tetrahedra around it.
  bool first_tetrahedron() {
    const auto n = static_cast<Index>(sites_.size());
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
    for (const Index t : id) tets_[t].lock.store(0, std::memory_order_relaxed);
    tets_[id[4]].corner = c, tets_[id[4]].neighbour = {id[0], id[1], id[2], id[3]};
    set_sphere(tets_[id[4]], 0);
    for (int k = 0; k < 4; ++k) {
      // The infinite vertex replaces corner k on the other side of the facet: swap two corners to keep the
      // orientation.
      Tetrahedron& t = tets_[id[k]];
      t.corner = c, t.neighbour = {id[0], id[1], id[2], id[3]};
      t.corner[k] = kNone, t.neighbour[k] = id[4];
      const int i = k == 0 ? 1 : 0, j = k <= 1 ? 2 : 1;
      std::swap(t.corner[i], t.corner[j]), std::swap(t.neighbour[i], t.neighbour[j]);
      set_sphere(t, i);
      at_[c[k]].store(id[4], std::memory_order_relaxed);
    }
    return true;
  }

  bool insert_round(const std::vector<Index>& round) {
    if (workers_.size() < 2 || round.size() < kSmallRound) return insert_alone(round);
    // A worker takes batches of its own part first, far from the other workers, then of the other parts.
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
      // Ends: after some doublings there are slots for any site's tetrahedra.
      for (; result == Insertion::Full; result = insert<false>(workers_[0], p)) grow(2 * capacity_);
      if (result != Insertion::Done) return false;
    }
    return true;
  }

  template <bool kShared>
  bool acquire(Worker& w, Index t) {
    if (!kShared) return true;
    std::uint8_t none = 0;
    return tets_[t].lock.compare_exchange_strong(none, w.id, std::memory_order_acquire,
                                                 std::memory_order_relaxed);
  }
  template <bool kShared>
  void release(Index t) {
    if (kShared) tets_[t].lock.store(0, std::memory_order_release);
  }
  template <bool kShared>
  Insertion give_up(Worker& w, Insertion why) {
    if (kShared)
      for (const Index t : w.locked) release<kShared>(t);
    return why;
  }

  // A tetrahedron whose sphere surely contains the site, or the tetrahedron that contains it, or an infinite
  // one beyond whose facet it lies. Returned locked; kNone if another worker holds a lock.
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
    // The walk ends: in a Delaunay triangulation the site's power to the spheres falls with every step across
    // a separating facet (Edelsbrunner 1989).
    for (bool moved = true; moved;) {
      moved = false;
      const Tetrahedron& now = tets_[t];
      if (squared_distance(now, sites_[p]) < now.in) break;
      const int infinite = now.infinite() ? now.corner_index(kNone) : -1;
      if (infinite >= 0 && from != kNone) break;  // it came through the hull facet
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
    tets_[start].mark = in;
    for (std::size_t i = 0; i < w.cavity.size(); ++i) {
      const Index t = w.cavity[i];
      for (int k = 0; k < 4; ++k) {
        const Index u = tets_[t].neighbour[k];
        Tetrahedron& next = tets_[u];
        if (kShared && next.lock.load(std::memory_order_relaxed) != w.id) {
          if (!acquire<kShared>(w, u)) return give_up<kShared>(w, Insertion::Busy);
          w.locked.push_back(u);
        }
        if (next.mark == in) continue;
        if (next.mark != out) {
          const CGAL::Sign sign = conflict(next, p);
          if (sign == CGAL::ZERO) return give_up<kShared>(w, Insertion::Tie);
          next.mark = sign == CGAL::POSITIVE ? in : out;
          if (sign == CGAL::POSITIVE) {
            w.cavity.push_back(u);
            continue;
          }
        }
        w.border.push_back({t, k, kNone});
      }
    }
    if (!reserve(w, w.border.size())) return give_up<kShared>(w, Insertion::Full);
    fill<kShared>(w, p);
    return Insertion::Done;
  }

  // Makes a new tetrahedron on each facet of the cavity's border.
  template <bool kShared>
  void fill(Worker& w, Index p) {
    for (Worker::Facet& f : w.border) {
      f.made = w.free.back();
      w.free.pop_back();
      Tetrahedron& made = tets_[f.made];
      const Tetrahedron& old = tets_[f.t];
      const Index u = old.neighbour[f.k];
      made.corner = old.corner, made.corner[f.k] = p;
      made.neighbour = {kNone, kNone, kNone, kNone}, made.neighbour[f.k] = u;
      tets_[u].neighbour[tets_[u].neighbour_index(f.t)] = f.made;
      made.mark = 0;
      set_sphere(made, f.k);
      for (const Index v : made.corner)
        if (v != kNone) at_[v].store(f.made, std::memory_order_release);
      if (kShared) w.locked.push_back(f.made);
    }
    join(w);
    alive_.fetch_add(static_cast<std::int64_t>(w.border.size()) - static_cast<std::int64_t>(w.cavity.size()),
                     std::memory_order_relaxed);
    for (const Index t : w.cavity) {
      tets_[t].corner[0] = kDead;
      tets_[t].mark = 0;
      w.free.push_back(t);
    }
    if (kShared) {
      // Empty slots stay locked, so that no worker takes a stale hint for a tetrahedron.
      for (const Index t : w.locked)
        if (tets_[t].corner[0] != kDead) release<kShared>(t);
    } else {
      for (const Worker::Facet& f : w.border) tets_[f.made].lock.store(0, std::memory_order_relaxed);
      for (const Index t : w.cavity) tets_[t].lock.store(w.id, std::memory_order_relaxed);
    }
  }

  // Links the new tetrahedra: two meet at every edge of the cavity's border, whose facets run along it in
  // opposite directions.
  void join(Worker& w) {
    if (w.border.size() > Worker::kFewFacets) return join_many(w);
    if (w.name.empty()) w.name.assign(sites_.size() + 1, 0);
    std::size_t count = 0;  // of the border's vertices, the infinite one (-1) included
    const auto name = [&](Index v) {
      std::uint8_t& i = w.name[static_cast<std::size_t>(v) + 1];
      if (i >= count || w.named[i] != v) i = static_cast<std::uint8_t>(count), w.named[count++] = v;
      return i;
    };
    for (std::size_t f = 0; f < w.border.size(); ++f) {
      const auto& c = tets_[w.border[f].made].corner;
      const auto& facet = kFacet[w.border[f].k];
      auto& ends = w.ends[f];
      for (int j = 0; j < 3; ++j) ends[j] = name(c[facet[j]]);
      for (int j = 0; j < 3; ++j) w.beside[ends[j]][ends[(j + 1) % 3]] = w.border[f].made;
    }
    for (std::size_t f = 0; f < w.border.size(); ++f) {
      const auto& facet = kFacet[w.border[f].k];
      const auto& ends = w.ends[f];
      for (int j = 0; j < 3; ++j)
        tets_[w.border[f].made].neighbour[facet[(j + 2) % 3]] = w.beside[ends[(j + 1) % 3]][ends[j]];
    }
  }

  void join_many(Worker& w) {
    std::size_t size = 64;
    while (size < 3 * w.border.size()) size *= 2;  // twice as many entries as edges
    if (w.edges.size() < size) w.edges.assign(size, {0, kNone, 0, 0}), w.insertion = 0;
    ++w.insertion;
    for (const Worker::Facet& f : w.border) {
      const auto& c = tets_[f.made].corner;
      const auto& facet = kFacet[f.k];
      for (int j = 0; j < 3; ++j) {
        const auto a = static_cast<std::uint32_t>(c[facet[j]]),
                   b = static_cast<std::uint32_t>(c[facet[(j + 1) % 3]]);
        const std::uint64_t edge = std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
        std::size_t i = (edge * 0x9e3779b97f4a7c15ULL >> 32) & (size - 1);
        while (w.edges[i].of == w.insertion && w.edges[i].sites != edge) i = (i + 1) & (size - 1);
        Worker::Edge& e = w.edges[i];
        const int k = facet[(j + 2) % 3];
        if (e.of != w.insertion) {
          e = {edge, f.made, k, w.insertion};
        } else {
          tets_[f.made].neighbour[k] = e.made;
          tets_[e.made].neighbour[e.k] = f.made;
        }
      }
    }
  }

  const TriangulationLimits& limits_;
  std::atomic<std::int64_t> alive_{0};  // tetrahedra
  const std::vector<Vec3>& sites_;
  std::unique_ptr<std::atomic<Index>[]> at_;  // a tetrahedron at each site; kNone before its insertion
  std::unique_ptr<Tetrahedron[]> tets_;
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
  if (!incremental_delaunay(sites, tets, limits)) tets = regular_tetrahedra(sites, {}, limits);
  return in_canonical_order(std::move(tets), sites.size());
}

}  // namespace filmsticking
