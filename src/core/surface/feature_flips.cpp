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

// What a flip must gain, in lengths of the longer diagonal: the bend of one degree, and more the rougher the
// film is around it, by the cube of its usual bends in units of the second. Noise bends all edges, a sharp
// edge the few across it. So clean surfaces have their flips, and noisy ones none: all that they would gain
// is other noise.
constexpr float kLeastGain = 0.02F, kNoisy = 0.25F;
// What is usual at a vertex: of the bends of its edges, this quantile; and of these, the median over the
// vertex and those around it.
constexpr float kUsual = 0.25F;
// Most flips are made in the first rounds. They end by themselves, since every flip lowers a sum; but there
// are films on which only one flip a round could be made.
constexpr int kRounds = 40;
// The sine of the angle between a face and its line of sight up to which it counts as seen edge-on.
constexpr double kEdgeOn = 1e-3;
constexpr std::size_t kChunk = 1024;

class FeatureFlips {
 public:
  FeatureFlips(Surface& film, std::vector<Index>& twins, const Vec3* viewpoint)
      : film_(film),
        twin_(twins),
        viewpoint_(viewpoint),
        normal_(film.triangles.size()),
        gain_(twin_.size()),
        swept_by_(film.triangles.size()),
        marked_(twin_.size()),
        tree_(film) {
    parallel_each(marked_.size(), [&](std::size_t h) { marked_[h].store(0, std::memory_order_relaxed); });
    parallel_each(normal_.size(), [&](std::size_t t) {
      swept_by_[t] = kNone;
      const Corners& c = film_.triangles[t];
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

  Index origin(Index h) const { return film_.triangles[h / 3][h % 3]; }
  Index target(Index h) const { return origin(next_in_face(h)); }
  Index apex(Index h) const { return origin(prev_in_face(h)); }
  // Edges are known by their half-edge of the lower number.
  Index edge(Index h) const { return twin_[h] == kNone ? h : std::min(h, twin_[h]); }
  bool is_edge(Index h) const { return twin_[h] > h; }

  // Of length 1, or 0 where there is none. From the corner of the least site, so that its last bit is the
  // same in any numbering.
  Normal normal(Index a, Index b, Index c) const {
    const Index i = film_.site[a], j = film_.site[b], k = film_.site[c];
    if (j < i && j < k) std::tie(a, b, c) = std::tuple(b, c, a);
    if (k < i && k < j) std::tie(a, b, c) = std::tuple(c, a, b);
    const Vec3& o = film_.positions[a];
    const Vec3 n = (film_.positions[b] - o).cross(film_.positions[c] - o);
    const double square = n.squaredNorm();
    return square > 0 ? Normal((n / std::sqrt(square)).cast<float>()) : Normal(0, 0, 0);
  }
  float length(Index a, Index b) const {
    return static_cast<float>((film_.positions[a] - film_.positions[b]).norm());
  }
  static float cube(float x) { return x * x * x; }
  static float bend(const Normal& m, const Normal& n) { return (m - n).norm(); }

  void measure_roughness() {
    std::vector<Index> some(film_.positions.size(), kNone);
    for (Index h = static_cast<Index>(twin_.size()); h-- > 0;)
      if (some[origin(h)] == kNone || twin_[h] == kNone) some[origin(h)] = h;  // the first of a fan
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

  // Of the two half-edges of an edge, the one from the site of the lower number.
  Index canonical(Index h) const { return film_.site[origin(h)] < film_.site[target(h)] ? h : twin_[h]; }

  // By how much flipping an edge lowers the sum of bends; 0 where that is too little.
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
    const Vec3 ray = *viewpoint_ - film_.positions[corner];
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

  // Does g go before h? By what no numbering changes.
  bool before(Index g, Index h) const {
    if (gain_[g] != gain_[h]) return gain_[g] > gain_[h];
    const auto sites = [&](Index e) { return std::minmax(film_.site[origin(e)], film_.site[target(e)]); };
    return sites(g) < sites(h);
  }

  // Those whose gain no better one changes, and that change no better one's: nothing before them in the faces
  // that they flip, nor in the faces around these.
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

  // What flips at once must not meet, either: where two would, the better one is made and the other waits.
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
      if (verdict[i] == Verdict::Never) gain_[best[i]] = 0;  // until something beside it changes
    }
    parallel_each(made.size(), [&](std::size_t i) { flip(made[i]); });
    return made;
  }

  enum class Verdict : char { Made, Waits, Never };

  // a, b, c, d of the edge ab with the apexes c and d.
  Four corners(Index h) const { return {origin(h), target(h), apex(h), apex(twin_[h])}; }
  template <std::size_t N>
  Box box_of(const std::array<Index, N>& vertices) const {
    Box box(film_.positions[vertices[0]]);
    for (std::size_t i = 1; i < N; ++i) box.extend(film_.positions[vertices[i]]);
    return box;
  }

  Verdict try_flip(Index h) const {
    const Index g = canonical(h);
    const Four tet = corners(g);
    const Index c = tet[2], d = tet[3];
    if (c == d || have_edge(film_.triangles, twin_, prev_in_face(g), prev_in_face(twin_[g])))
      return Verdict::Never;
    Box box = box_of(tet);
    box.min().array() -= kMeetingMargin, box.max().array() += kMeetingMargin;
    const Fence fence(film_.positions, tet);
    Verdict verdict = Verdict::Made;
    tree_.all(FaceTree::rounded(box), [&](Index t) {
      const Index other = swept_by_[t];
      if (other == h) return true;
      if (other != kNone && before(other, h)) {
        const Four swept = corners(other);
        if (box_of(swept).intersects(box)) {
          const bool same_edge = std::minmax(c, d) == std::minmax(swept[2], swept[3]);
          if (same_edge || !(fence.keeps_out(swept) ||
                             Meeting(film_.positions, tet, swept, kMeetingMargin).in_common_corners_only()))
            verdict = Verdict::Waits;
        }
      }
      const Corners& face = film_.triangles[t];
      if (!box_of(face).intersects(box) || fence.keeps_out(face)) return true;
      if (Meeting(film_.positions, tet, face, kMeetingMargin).in_common_corners_only()) return true;
      verdict = Verdict::Never;
      return false;
    });
    return verdict;
  }

  // Planes through the outer edges of two faces, across them: what is beyond one of these meets the
  // tetrahedron of the faces' corners in common corners only. Most faces around are, and this is soon found.
  class Fence {
   public:
    Fence(const std::vector<Vec3>& positions, const Four& tet) : positions_(positions) {
      const auto& [a, b, c, d] = tet;
      const Vec3 ab = positions[b] - positions[a], cd = positions[d] - positions[c];
      const Vec3 up = ab.cross(cd);
      const Four from{b, c, a, d}, to{c, a, d, b};
      for (int k = 0; k < 4; ++k) {
        // up is away from the film or into it; what is inside tells which side is out.
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
    flip_edge(film_.triangles, twin_, h);
    normal_[t] = normal(d, c, a), normal_[u] = normal(c, d, b);
  }

  // Those left, and of what the flips have changed, the edges of their faces and of the faces around these,
  // those that gain now.
  std::vector<Index> next_candidates(std::vector<Index> candidates, const std::vector<Index>& made) {
    std::vector<std::vector<Index>> parts((made.size() + kChunk - 1) / kChunk);
    parallel_chunks(made.size(), kChunk, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
      // Which of two flips marks an edge between them is chance; nothing depends on it.
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
      gain_[twin_[h]] = 0;  // which was the edge's number, perhaps
      marked_[h].store(0, std::memory_order_relaxed);
    });
    for (const Index h : changed)
      if (gain_[h] > 0) candidates.push_back(h);
    return candidates;
  }

  Surface& film_;
  std::vector<Index>& twin_;
  const Vec3* viewpoint_;
  UnsetVector<Normal> normal_;   // of every face
  UnsetVector<float> rough_;     // of every vertex: the bend that is usual around there
  UnsetVector<float> gain_;      // of every edge, at its half-edge of the lower number; 0: it is no candidate
  UnsetVector<Index> swept_by_;  // of every face: the edge beside it that this round may flip, or kNone
  std::vector<std::atomic<char>> marked_;  // of every edge: it is in a list already
  FaceTree tree_;
};

}  // namespace

std::int64_t flip_to_features(Surface& film, std::vector<Index>& twins, const Cancel& cancel,
                              const Vec3* viewpoint) {
  return FeatureFlips(film, twins, viewpoint).run(cancel);
}

}  // namespace filmsticking
