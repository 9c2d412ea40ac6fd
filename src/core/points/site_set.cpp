// SPDX-License-Identifier: GPL-3.0-or-later
#include "points/site_set.h"

#include <tbb/parallel_sort.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "geometry/parallel.h"

namespace filmsticking {
namespace {

// Distance from the median point, over that within which two thirds of the points lie. Beyond, a point would
// decide the scale of all others: the perturbation would be 2e-4 of their extent. A third as in outliers.cpp.
constexpr double kAbsurd = 1e4;
constexpr double kCore = 2. / 3;

// In units of the box. A rotated plane is as thick as this after rounding to float.
constexpr double kFlat = 3e-7;

std::uint64_t mix(std::uint64_t x) {
  x ^= x >> 33;
  x *= 0xff51afd7ed558ccdULL;
  x ^= x >> 33;
  x *= 0xc4ceb9fe1a85ec53ULL;
  return x ^ (x >> 33);
}

bool precedes(const Vec3& p, const Vec3& q) {
  return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
}

std::uint64_t bits_of(double x) {
  std::uint64_t bits;
  x += 0.0;  // -0 becomes 0
  std::memcpy(&bits, &x, sizeof bits);
  return bits;
}

std::uint64_t hash(const Vec3& p) {
  std::uint64_t h = 0;
  for (int k = 0; k < 3; ++k) h = mix(h ^ bits_of(p[k])) + 0x9e3779b97f4a7c15ULL;
  return h;
}

// Spreads 21 bits to every third bit.
std::uint64_t spread(std::uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffffULL;
  x = (x | x << 16) & 0x1f0000ff0000ffULL;
  x = (x | x << 8) & 0x100f00f00f00f00fULL;
  x = (x | x << 4) & 0x10c30c30c30c30c3ULL;
  return (x | x << 2) & 0x1249249249249249ULL;
}

std::uint64_t morton(const Vec3& p) {
  std::uint64_t code = 0;
  for (int k = 0; k < 3; ++k) {
    const double cell = std::clamp((p[k] + 0.5) * 2097151.0, 0.0, 2097151.0);
    code |= spread(static_cast<std::uint64_t>(cell)) << k;
  }
  return code;
}

// The 24 rotations of a cube onto itself.
std::vector<AxisTurn> axis_turns() {
  std::vector<AxisTurn> turns;
  std::array<int, 3> axis{0, 1, 2};
  do {
    const bool odd = (axis[0] > axis[1]) != ((axis[1] > axis[2]) != (axis[0] > axis[2]));
    for (int minus = 0; minus < 8; ++minus) {
      const AxisTurn turn{axis, {minus & 1 ? -1. : 1., minus & 2 ? -1. : 1., minus & 4 ? -1. : 1.}};
      if ((turn.sign[0] * turn.sign[1] * turn.sign[2] < 0) == odd) turns.push_back(turn);
    }
  } while (std::next_permutation(axis.begin(), axis.end()));
  return turns;
}

// The turn with the least key. The key is the sums of the coordinates' hashes, per axis; among equal keys the
// sum of the points' hashes decides. Sums of integers do not depend on the order of the points.
AxisTurn canonical_turn(const std::vector<Vec3>& points) {
  std::array<std::array<std::uint64_t, 2>, 3> sum{};  // per axis, as given and mirrored
  for (const Vec3& p : points)
    for (int k = 0; k < 3; ++k) {
      sum[k][0] += mix(bits_of(p[k]));
      sum[k][1] += mix(bits_of(-p[k]));
    }
  const auto by_axes = [&](const AxisTurn& turn) {
    std::array<std::uint64_t, 3> key{};
    for (int k = 0; k < 3; ++k) key[k] = sum[turn.axis[k]][turn.sign[k] < 0];
    return key;
  };
  std::vector<AxisTurn> turns = axis_turns();
  std::stable_sort(turns.begin(), turns.end(),
                   [&](const AxisTurn& a, const AxisTurn& b) { return by_axes(a) < by_axes(b); });
  AxisTurn best = turns[0];
  std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
  for (const AxisTurn& turn : turns) {
    if (by_axes(turn) != by_axes(turns[0])) break;
    if (by_axes(turns[1]) != by_axes(turns[0])) break;  // one turn alone has the least key
    std::uint64_t key = 0;
    for (const Vec3& p : points) key += mix(hash(turn(p)));
    if (key < least) least = key, best = turn;
  }
  return best;
}

// A finite point and its place along the curve.
struct Entry {
  std::uint64_t code;
  std::int32_t id;
};

Vec3 place_of(const PointsView& points, const Entry& entry) {
  const Point p = points[static_cast<std::size_t>(entry.id)];
  return {p[0], p[1], p[2]};
}

double middle(std::vector<double>& values) {
  const std::size_t half = values.size() / 2;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(half), values.end());
  if (values.size() % 2 != 0) return values[half];
  // The mean of both middles, so that a mirrored cloud has the mirrored median.
  const double below = *std::max_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(half));
  return 0.5 * below + 0.5 * values[half];
}

// Drops points absurdly far from all the rest, as values that stand for "no return".
void drop_absurd(const PointsView& points, std::vector<Entry>& entries, SiteSet& set) {
  Vec3 median;
  std::vector<double> values(entries.size());
  for (int k = 0; k < 3; ++k) {
    for (std::size_t i = 0; i < entries.size(); ++i) values[i] = place_of(points, entries[i])[k];
    median[k] = middle(values);
  }
  // Along the axes: squares would overflow.
  const auto distance = [&](const Entry& entry) {
    return (place_of(points, entry) * 0.5 - median * 0.5).cwiseAbs().maxCoeff();
  };
  for (std::size_t i = 0; i < entries.size(); ++i) values[i] = distance(entries[i]);
  const auto core = values.begin() + static_cast<std::ptrdiff_t>(kCore * static_cast<double>(values.size()));
  std::nth_element(values.begin(), core, values.end());
  const double most = kAbsurd * *core;
  if (!(most > 0)) return;  // two thirds of the points are equal
  const auto far = std::partition(entries.begin(), entries.end(),
                                  [&](const Entry& entry) { return distance(entry) <= most; });
  std::vector<Vec3> dropped;
  std::for_each(far, entries.end(), [&](const Entry& entry) { dropped.push_back(place_of(points, entry)); });
  entries.erase(far, entries.end());
  std::sort(dropped.begin(), dropped.end(), precedes);
  set.absurd = std::distance(dropped.begin(), std::unique(dropped.begin(), dropped.end()));
  set.duplicates = static_cast<std::int64_t>(dropped.size()) - set.absurd;
}

// Also sets the input's box.
std::vector<Entry> finite_points(const PointsView& points, bool keep_absurd, SiteSet& set) {
  std::vector<Entry> entries;
  entries.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point p = points[i];
    if (std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]))
      entries.push_back({0, static_cast<std::int32_t>(i)});
  }
  set.non_finite = static_cast<std::int64_t>(points.size() - entries.size());
  if (!keep_absurd && !entries.empty()) drop_absurd(points, entries, set);
  if (entries.empty()) return entries;
  Vec3 lo = place_of(points, entries[0]), hi = lo;
  for (const Entry& entry : entries) {
    const Vec3 v = place_of(points, entry);
    lo = lo.cwiseMin(v);
    hi = hi.cwiseMax(v);
  }
  // Halves first: the box of extreme coordinates must not overflow.
  set.centre = lo * 0.5 + hi * 0.5;
  const double half = (hi * 0.5 - lo * 0.5).maxCoeff();
  set.side = half > 0 ? std::min(half, std::numeric_limits<double>::max() / 4) * 2 : 1;
  return entries;
}

void sort_along_curve(const PointsView& points, const SiteSet& set, std::vector<Entry>& entries) {
  parallel_each(entries.size(), [&](std::size_t i) {
    entries[i].code = morton(set.to_unit(points[static_cast<std::size_t>(entries[i].id)]));
  });
  tbb::parallel_sort(entries.begin(), entries.end(), [&](const Entry& a, const Entry& b) {
    if (a.code != b.code) return a.code < b.code;
    const Vec3 p = place_of(points, a), q = place_of(points, b);
    if (p == q) return a.id < b.id;
    return precedes(set.turn(p), set.turn(q));
  });
}

// Equal points have equal codes and stand side by side. Returns how many were dropped.
std::int64_t drop_repeated(const PointsView& points, std::vector<Entry>& entries) {
  const auto distinct = std::unique(entries.begin(), entries.end(), [&](const Entry& a, const Entry& b) {
    return place_of(points, a) == place_of(points, b);
  });
  const std::int64_t repeated = std::distance(distinct, entries.end());
  entries.erase(distinct, entries.end());
  return repeated;
}

// Moved by less than kPerturbation along each axis, by a hash of the coordinates.
Vec3 perturbed(const Vec3& p) {
  std::uint64_t h = hash(p);
  Vec3 shift;
  for (int k = 0; k < 3; ++k) {
    h = mix(h + 0x9e3779b97f4a7c15ULL);
    shift[k] = (static_cast<double>(h >> 11) * (2.0 / 9007199254740992.0) - 1.0) * kPerturbation;
  }
  return p + shift;
}

}  // namespace

SiteSet make_site_set(const PointsView& points, bool keep_absurd) {
  SiteSet set;
  std::vector<Entry> entries = finite_points(points, keep_absurd, set);
  if (entries.empty()) return set;
  sort_along_curve(points, set, entries);
  set.duplicates += drop_repeated(points, entries);

  const auto unit_place = [&](std::size_t i) {
    return set.to_unit(points[static_cast<std::size_t>(entries[i].id)]);
  };
  set.perturbed.resize(entries.size());  // neither turned nor perturbed yet
  parallel_each(entries.size(), [&](std::size_t i) { set.perturbed[i] = unit_place(i); });
  set.turn = canonical_turn(set.perturbed);
  sort_along_curve(points, set, entries);
  set.input.resize(entries.size());
  parallel_each(entries.size(), [&](std::size_t i) {
    set.input[i] = entries[i].id;
    set.perturbed[i] = perturbed(unit_place(i));
  });
  return set;
}

bool SiteSet::coplanar(const PointsView& points) const {
  auto farthest = [&](auto&& distance) {
    std::size_t best = 0;
    double most = -1;
    for (std::size_t i = 0; i < size(); ++i)
      if (const double d = distance(exact(points, i)); d > most) most = d, best = i;
    return exact(points, best);
  };
  const Vec3 a = exact(points, 0);
  const Vec3 b = farthest([&](const Vec3& x) { return (x - a).squaredNorm(); });
  const Vec3 u = (b - a).normalized();
  auto off_line = [&](const Vec3& x) { return Vec3(x - a - u.dot(x - a) * u); };
  const Vec3 v = off_line(farthest([&](const Vec3& x) { return off_line(x).squaredNorm(); }));
  if (v.norm() < kFlat) return true;
  const Vec3 n = u.cross(v.normalized());
  for (std::size_t i = 0; i < size(); ++i)
    if (!(std::abs(n.dot(exact(points, i) - a)) < kFlat)) return false;
  return true;
}

}  // namespace filmsticking
