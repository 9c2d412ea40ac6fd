// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/feature_flips.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "geometry/face_tree.h"
#include "geometry/meeting.h"
#include "geometry/parallel.h"
#include "geometry/quantile.h"
#include "geometry/triangle_adjacency.h"
#include "geometry/unset_vector.h"

namespace filmsticking {
namespace {

// Least gain of a flip on a smooth surface, in lengths of the longer diagonal: a bend of about one degree.
constexpr float kLeastGain = 0.02F;
// Usual bend at which the least gain grows by one such length. It grows by the cube of the usual bend. Noise
// bends all edges, a sharp edge only the few across it, so noisy surfaces have no flips.
constexpr float kNoisy = 0.25F;
// Quantile of the bends around a vertex. The usual bend is the median of it over the vertex and its
// neighbours.
constexpr float kUsual = 0.25F;
// Most rounds. Flips end without it, since each lowers a sum, but some surfaces allow one flip a round.
constexpr int kRounds = 40;
// Sine of the angle between a face and its line of sight. Below: seen edge-on.
constexpr double kEdgeOn = 1e-3;
constexpr std::size_t kChunk = 1024;

class FeatureFlips {
 public:
  FeatureFlips(Surface& surface, std::vector<Index>& twins, const Vec3* viewpoint)
      : surface_(surface),
        twin_(twins),
        viewpoint_(viewpoint),
        normal_(surface.triangles.size()),
        gain_(twin_.size()),
        swept_by_(surface.triangles.size()),
        marked_(twin_.size()),
        tree_(surface) {
    parallel_each(marked_.size(), [&](std::size_t h) { marked_[h].store(0, std::memory_order_relaxed); });
    parallel_each(normal_.size(), [&](std::size_t t) {
      swept_by_[t] = kNone;
      const Corners& c = surface_.triangles[t];
      normal_[t] = normal(c[0], c[1], c[2]);
    });
    measure_roughness();
  }

  std::int64_t run(const Cancel& cancel) {
    std::vector<Index> candidates = first_candidates();
    std::int64_t flips = 0;
    for (int round = 0; round < kRounds && !candidates.empty(); ++round) {
      cancel();
      const std::vector<Index> best = best_of(candidates);
      const std::vector<Index> made = flip_those_that_may(best);
      flips += static_cast<std::int64_t>(made.size());
      candidates = next_candidates(std::move(candidates), made);
    }
    return flips;
  }

 private:
  using Four = std::array<Index, 4>;
  using Normal = Eigen::Vector3f;
  using Box = Eigen::AlignedBox3d;

  Index origin(Index h) const { return surface_.triangles[h / 3][h % 3]; }
  Index target(Index h) const { return origin(next_in_face(h)); }
  Index apex(Index h) const { return origin(prev_in_face(h)); }
  // An edge is named by its half-edge of the lower number.
  Index edge(Index h) const { return twin_[h] == kNone ? h : std::min(h, twin_[h]); }
  bool is_edge(Index h) const { return twin_[h] > h; }

  // Of length 1, or 0 for a face without area. Start at the least site, so that rounding does not depend on
  // the numbering.
  Normal normal(Index a, Index b, Index c) const {
    const Index i = surface_.site[a], j = surface_.site[b], k = surface_.site[c];
    if (j < i && j < k) std::tie(a, b, c) = std::tuple(b, c, a);
    if (k < i && k < j) std::tie(a, b, c) = std::tuple(c, a, b);
    const Vec3& o = surface_.positions[a];
    const Vec3 n = (surface_.positions[b] - o).cross(surface_.positions[c] - o);
    const double square = n.squaredNorm();
    return square > 0 ? Normal((n / std::sqrt(square)).cast<float>()) : Normal(0, 0, 0);
  }
  float length(Index a, Index b) const {
    return static_cast<float>((surface_.positions[a] - surface_.positions[b]).norm());
  }
  static float cube(float x) { return x * x * x; }
  static float bend(const Normal& m, const Normal& n) { return (m - n).norm(); }

  void measure_roughness() {
    std::vector<Index> some(surface_.positions.size(), kNone);
    for (Index h = static_cast<Index>(twin_.size()); h-- > 0;)
      if (some[origin(h)] == kNone || twin_[h] == kNone) some[origin(h)] = h;  // a fan starts at its open end
    const auto around = [&](std::size_t v, std::vector<float>& values, float share, const auto& add) {
      values.clear();
      Index g = some[v];
      while (g != kNone) {
        add(g);
        g = twin_[prev_in_face(g)];
        if (g == some[v]) break;
      }
      if (values.empty()) return 0.0F;
      return quantile(values.begin(), values.end(), share);
    };
    UnsetVector<float> own(some.size());
    rough_.resize(some.size());
    parallel_chunks(some.size(), kChunk, [&](std::size_t, std::size_t begin, std::size_t end) {
      std::vector<float> bends;
      for (std::size_t v = begin; v < end; ++v)
        own[v] = around(v, bends, kUsual, [&](Index g) {
          if (twin_[g] != kNone) bends.push_back(bend(normal_[g / 3], normal_[twin_[g] / 3]));
        });
    });
    parallel_chunks(some.size(), kChunk, [&](std::size_t, std::size_t begin, std::size_t end) {
      std::vector<float> values;
      for (std::size_t v = begin; v < end; ++v)
        rough_[v] = around(v, values, 0.5F, [&](Index g) {
          if (values.empty()) values.push_back(own[v]);
          values.push_back(own[target(g)]);
        });
    });
  }

  // The half-edge of an edge that starts at the lesser site.
  Index canonical(Index h) const {
    return surface_.site[origin(h)] < surface_.site[target(h)] ? h : twin_[h];
  }

  // What a flip lowers the sum of bends by; 0 if that is too little.
  float gain(Index h) const {
    h = canonical(h);
    const Index u = twin_[h], a = origin(h), b = target(h), c = apex(h), d = apex(u);
    const Index side[4] = {next_in_face(h), prev_in_face(h), next_in_face(u),
                           prev_in_face(u)};  // bc ca ad db
    const Index ends[4][2] = {{b, c}, {c, a}, {a, d}, {d, b}};
    const float ab = length(a, b), cd = length(c, d);
    const float usual = (rough_[a] + rough_[b] + rough_[c] + rough_[d]) / 4;
    const float needed = (kLeastGain + cube(usual / kNoisy)) * std::max(ab, cd);
    float before = ab * bend(normal_[h / 3], normal_[u / 3]), len[4];
    for (int k = 0; k < 4; ++k) {
      len[k] = length(ends[k][0], ends[k][1]);
      if (twin_[side[k]] != kNone) before += len[k] * bend(normal_[side[k] / 3], normal_[twin_[side[k]] / 3]);
    }
    if (before <= needed) return 0;
    const Normal at_a = normal(a, d, c), at_b = normal(b, c, d);
    if (at_a.isZero(0) || at_b.isZero(0) || !shows_front(at_a, a) || !shows_front(at_b, b)) return 0;
    float after = cd * bend(at_a, at_b);
    for (int k = 0; k < 4; ++k)
      if (twin_[side[k]] != kNone)
        after += len[k] * bend(k == 0 || k == 3 ? at_b : at_a, normal_[twin_[side[k]] / 3]);
    return before - after > needed ? before - after : 0;
  }

  bool shows_front(const Normal& normal, Index corner) const {
    if (viewpoint_ == nullptr) return true;
    const Vec3 ray = *viewpoint_ - surface_.positions[corner];
    return normal.cast<double>().dot(ray) > kEdgeOn * ray.norm();
  }

  std::vector<Index> first_candidates() {
    parallel_each(gain_.size(), [&](std::size_t h) {
      gain_[h] = is_edge(static_cast<Index>(h)) ? gain(static_cast<Index>(h)) : 0;
    });
    std::vector<Index> candidates;
    for (std::size_t h = 0; h < gain_.size(); ++h)
      if (gain_[h] > 0) candidates.push_back(static_cast<Index>(h));
    return candidates;
  }

  // Is g flipped before h? Independent of the numbering.
  bool before(Index g, Index h) const {
    if (gain_[g] != gain_[h]) return gain_[g] > gain_[h];
    const auto sites = [&](Index e) {
      return std::minmax(surface_.site[origin(e)], surface_.site[target(e)]);
    };
    return sites(g) < sites(h);
  }

  // The candidates that can flip at once: no better candidate is in their two faces or in the faces around
  // these, so their gains do not depend on each other.
  std::vector<Index> best_of(const std::vector<Index>& candidates) const {
    std::vector<char> is_best(candidates.size(), 0);
    parallel_each(candidates.size(), [&](std::size_t i) {
      const Index h = candidates[i];
      const auto beaten_by = [&](Index g) {
        const Index e = edge(g);
        return e != h && gain_[e] > 0 && before(e, h);
      };
      for (const Index t : {h / 3, twin_[h] / 3})
        for (Index g = 3 * t; g < 3 * t + 3; ++g) {
          if (beaten_by(g)) return;
          if (const Index k = twin_[g];
              k != kNone && (beaten_by(next_in_face(k)) || beaten_by(prev_in_face(k))))
            return;
        }
      is_best[i] = 1;
    });
    std::vector<Index> best;
    for (std::size_t i = 0; i < candidates.size(); ++i)
      if (is_best[i]) best.push_back(candidates[i]);
    return best;
  }

  // Flips at once must not meet each other: the better one is made and the other waits.
  std::vector<Index> flip_those_that_may(const std::vector<Index>& best) {
    for (const Index h : best)
      for (const Index t : {h / 3, twin_[h] / 3})
        swept_by_[t] = h, tree_.add(t, FaceTree::rounded(box_of(corners(h))));
    std::vector<Verdict> verdict(best.size());
    parallel_each(best.size(), [&](std::size_t i) { verdict[i] = try_flip(best[i]); });
    for (const Index h : best) swept_by_[h / 3] = swept_by_[twin_[h] / 3] = kNone;
    std::vector<Index> made;
    for (std::size_t i = 0; i < best.size(); ++i) {
      if (verdict[i] == Verdict::Made) made.push_back(best[i]);
      if (verdict[i] == Verdict::Never) gain_[best[i]] = 0;  // until a flip beside it
    }
    parallel_each(made.size(), [&](std::size_t i) { flip(made[i]); });
    return made;
  }

  enum class Verdict : char { Made, Waits, Never };

  // a, b, c, d: the edge ab and the corners c and d opposite to it.
  Four corners(Index h) const { return {origin(h), target(h), apex(h), apex(twin_[h])}; }
  template <std::size_t N>
  Box box_of(const std::array<Index, N>& vertices) const {
    Box box(surface_.positions[vertices[0]]);
    for (std::size_t i = 1; i < N; ++i) box.extend(surface_.positions[vertices[i]]);
    return box;
  }

  Verdict try_flip(Index h) const {
    const Index g = canonical(h);
    const Four tet = corners(g);
    const Index c = tet[2], d = tet[3];
    if (c == d || have_edge(surface_.triangles, twin_, prev_in_face(g), prev_in_face(twin_[g])))
      return Verdict::Never;
    Box box = box_of(tet);
    box.min().array() -= kMeetingMargin, box.max().array() += kMeetingMargin;
    const Fence fence(surface_.positions, tet);
    Verdict verdict = Verdict::Made;
    tree_.all(FaceTree::rounded(box), [&](Index t) {
      const Index other = swept_by_[t];
      if (other == h) return true;
      if (other != kNone && before(other, h)) {
        const Four swept = corners(other);
        if (box_of(swept).intersects(box)) {
          const bool same_edge = std::minmax(c, d) == std::minmax(swept[2], swept[3]);
          if (same_edge ||
              !(fence.keeps_out(swept) ||
                Meeting(surface_.positions, tet, swept, kMeetingMargin).in_common_corners_only()))
            verdict = Verdict::Waits;
        }
      }
      const Corners& face = surface_.triangles[t];
      if (!box_of(face).intersects(box) || fence.keeps_out(face)) return true;
      if (Meeting(surface_.positions, tet, face, kMeetingMargin).in_common_corners_only()) return true;
      verdict = Verdict::Never;
      return false;
    });
    return verdict;
  }

  // Planes through the outer edges of two faces, across them. A face beyond one of these planes meets the
  // tetrahedron of the four corners in common corners only. A quick test that most faces around pass.
  class Fence {
   public:
    Fence(const std::vector<Vec3>& positions, const Four& tet) : positions_(positions) {
      const auto& [a, b, c, d] = tet;
      const Vec3 ab = positions[b] - positions[a], cd = positions[d] - positions[c];
      const Vec3 up = ab.cross(cd);
      const Four from{b, c, a, d}, to{c, a, d, b};
      for (int k = 0; k < 4; ++k) {
        // `up` may point to either side of the surface; the other corners show which side is out.
        const Vec3 &p = positions[from[k]], &q = positions[to[k]];
        Vec3 out = (q - p).cross(up);
        const double norm = out.norm();
        if (!(norm > 0)) continue;
        out /= norm;
        double most = -1e300, least = 1e300;
        for (const Index v : tet)
          if (v != from[k] && v != to[k]) {
            const double x = out.dot(positions[v] - p);
            most = std::max(most, x), least = std::min(least, x);
          }
        if (least > kMeetingMargin) out = -out, most = -least;
        if (most >= -kMeetingMargin) continue;
        post_[count_] = from[k], end_[count_] = to[k], out_[count_++] = out;
      }
    }

    template <std::size_t N>
    bool keeps_out(const std::array<Index, N>& vertices) const {
      for (int k = 0; k < count_; ++k) {
        bool out = true;
        for (std::size_t i = 0; i < N && out; ++i) {
          const Index v = vertices[i];
          out = v == post_[k] || v == end_[k] ||
                out_[k].dot(positions_[v] - positions_[post_[k]]) > kMeetingMargin;
        }
        if (out) return true;
      }
      return false;
    }

   private:
    const std::vector<Vec3>& positions_;
    Four post_, end_;
    std::array<Vec3, 4> out_;
    int count_ = 0;
  };

  void flip(Index h) {
    const auto [a, b, c, d] = corners(h);
    const Index t = h / 3, u = twin_[h] / 3;
    flip_edge(surface_.triangles, twin_, h);
    normal_[t] = normal(d, c, a), normal_[u] = normal(c, d, b);
  }

  // The candidates that are left, and the edges near a flip that gain now: those of its faces and of the
  // faces around these.
  std::vector<Index> next_candidates(std::vector<Index> candidates, const std::vector<Index>& made) {
    std::vector<std::vector<Index>> parts((made.size() + kChunk - 1) / kChunk);
    parallel_chunks(made.size(), kChunk, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
      // Two flips may race to mark an edge between them; the result is the same.
      const auto add = [&](Index g) {
        const Index h = edge(g);
        if (is_edge(h) && marked_[h].exchange(1, std::memory_order_relaxed) == 0) parts[chunk].push_back(h);
      };
      for (std::size_t i = begin; i < end; ++i)
        for (const Index t : {made[i] / 3, twin_[made[i]] / 3})
          for (Index g = 3 * t; g < 3 * t + 3; ++g) {
            add(g);
            if (const Index k = twin_[g]; k != kNone) add(next_in_face(k)), add(prev_in_face(k));
          }
    });
    candidates.erase(
        std::remove_if(candidates.begin(), candidates.end(),
                       [&](Index h) { return !(gain_[h] > 0) || !is_edge(h) || marked_[h] != 0; }),
        candidates.end());
    std::vector<Index> changed;
    for (const auto& part : parts) changed.insert(changed.end(), part.begin(), part.end());
    parallel_each(changed.size(), [&](std::size_t i) {
      const Index h = changed[i];
      gain_[h] = gain(h);
      gain_[twin_[h]] = 0;  // this half-edge may have named the edge before
      marked_[h].store(0, std::memory_order_relaxed);
    });
    for (const Index h : changed)
      if (gain_[h] > 0) candidates.push_back(h);
    return candidates;
  }

  Surface& surface_;
  std::vector<Index>& twin_;
  const Vec3* viewpoint_;
  UnsetVector<Normal> normal_;             // [face]
  UnsetVector<float> rough_;               // [vertex]: the usual bend
  UnsetVector<float> gain_;                // [edge]; 0: no candidate
  UnsetVector<Index> swept_by_;            // [face]: its edge that this round may flip, or kNone
  std::vector<std::atomic<char>> marked_;  // [edge]: 1 if it is in a list already
  FaceTree tree_;
};

}  // namespace

std::int64_t flip_to_features(Surface& surface, std::vector<Index>& twins, const Cancel& cancel,
                              const Vec3* viewpoint) {
  return FeatureFlips(surface, twins, viewpoint).run(cancel);
}

}  // namespace filmsticking
