// SPDX-License-Identifier: GPL-3.0-or-later
#include "site_set.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace filmsticking {
namespace {

// Flatter than this share of the box is flat: what a turned plane has left after rounding to float.
constexpr double kFlat = 3e-7;

std::uint64_t mix(std::uint64_t x) {
  x ^= x >> 33;
  x *= 0xff51afd7ed558ccdULL;
  x ^= x >> 33;
  x *= 0xc4ceb9fe1a85ec53ULL;
  return x ^ (x >> 33);
}

std::uint64_t hash(const Vec3& p) {
  std::uint64_t h = 0;
  for (int k = 0; k < 3; ++k) {
    std::uint64_t bits;
    const double x = p[k] + 0.0;  // -0 becomes 0
    std::memcpy(&bits, &x, sizeof bits);
    h = mix(h ^ bits) + 0x9e3779b97f4a7c15ULL;
  }
  return h;
}

// 21 bits spread to every third place.
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

}  // namespace

SiteSet make_site_set(const std::vector<Point>& points) {
  SiteSet set;
  struct Entry {
    std::uint64_t code;
    std::int32_t id;
  };
  std::vector<Entry> entries;
  entries.reserve(points.size());
  const double inf = std::numeric_limits<double>::infinity();
  Vec3 lo(inf, inf, inf), hi(-inf, -inf, -inf);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& p = points[i];
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) {
      ++set.non_finite;
      continue;
    }
    const Vec3 v(p[0], p[1], p[2]);
    lo = lo.cwiseMin(v);
    hi = hi.cwiseMax(v);
    entries.push_back({0, static_cast<std::int32_t>(i)});
  }
  if (entries.empty()) return set;
  // Halves first: the box of extreme coordinates must not overflow.
  set.centre = lo * 0.5 + hi * 0.5;
  const double half = (hi * 0.5 - lo * 0.5).maxCoeff();
  set.side = half > 0 ? std::min(half, std::numeric_limits<double>::max() / 4) * 2 : 1;

  for (Entry& e : entries) e.code = morton(set.to_unit(points[static_cast<std::size_t>(e.id)]));
  std::sort(entries.begin(), entries.end(), [&](const Entry& a, const Entry& b) {
    if (a.code != b.code) return a.code < b.code;
    const Point &p = points[static_cast<std::size_t>(a.id)], &q = points[static_cast<std::size_t>(b.id)];
    return p != q ? p < q : a.id < b.id;
  });
  set.positions.reserve(entries.size());
  set.input.reserve(entries.size());
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const Point& p = points[static_cast<std::size_t>(entries[k].id)];
    // Equal points have equal codes and stand side by side.
    if (k > 0 && points[static_cast<std::size_t>(entries[k - 1].id)] == p) {
      ++set.duplicates;
      continue;
    }
    set.positions.push_back(set.to_unit(p));
    set.input.push_back(entries[k].id);
  }
  set.perturbed.reserve(set.size());
  for (const Vec3& p : set.positions) {
    std::uint64_t h = hash(p);
    Vec3 shift;
    for (int k = 0; k < 3; ++k) {
      h = mix(h + 0x9e3779b97f4a7c15ULL);
      shift[k] = (static_cast<double>(h >> 11) * (2.0 / 9007199254740992.0) - 1.0) * kPerturbation;
    }
    set.perturbed.push_back(p + shift);
  }
  return set;
}

bool SiteSet::coplanar() const {
  const std::vector<Vec3>& p = positions;
  auto farthest = [&](auto&& distance) {
    std::size_t best = 0;
    for (std::size_t i = 0; i < p.size(); ++i)
      if (distance(p[i]) > distance(p[best])) best = i;
    return best;
  };
  const Vec3 a = p[0];
  const Vec3 b = p[farthest([&](const Vec3& x) { return (x - a).squaredNorm(); })];
  const Vec3 u = (b - a).normalized();
  auto off_line = [&](const Vec3& x) { return Vec3(x - a - u.dot(x - a) * u); };
  const Vec3 v = off_line(p[farthest([&](const Vec3& x) { return off_line(x).squaredNorm(); })]);
  if (v.norm() < kFlat) return true;
  const Vec3 n = u.cross(v.normalized());
  return std::all_of(p.begin(), p.end(), [&](const Vec3& x) { return std::abs(n.dot(x - a)) < kFlat; });
}

}  // namespace filmsticking
