// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "geometry/vec.h"

namespace filmsticking {

/// Distance of two pieces, in units of the box around the sites. Below: they may meet. More than the rounding
/// of float coordinates.
constexpr double kMeetingMargin = 1e-7;

/// Do two convex pieces of a surface meet in their common corners only? A piece is the hull of some vertices:
/// a face, or the four corners of two faces at an edge. Tests separating planes.
template <std::size_t M, std::size_t N>
class Meeting {
 public:
  /// `margin`: a distance in units of the positions; pieces nearer than this count as meeting.
  Meeting(const std::vector<Vec3>& positions, const std::array<Index, M>& a, const std::array<Index, N>& b,
          double margin)
      : margin_(margin) {
    // Small coordinates round less.
    const Vec3& origin = positions[a[0]];
    for (std::size_t i = 0; i < M; ++i) a_[i] = positions[a[i]] - origin;
    for (std::size_t j = 0; j < N; ++j) {
      b_[j] = positions[b[j]] - origin;
      for (std::size_t i = 0; i < M; ++i)
        if (a[i] == b[j]) common_a_[i] = common_b_[j] = any_ = true;
    }
  }

  /// True: they do. False: they do not, or rounding could decide.
  bool in_common_corners_only() const {
    if (parted_by_sides_of(b_) || parted_by_sides_of(a_)) return true;
    for (std::size_t j = 0; j < N; ++j)
      for (std::size_t l = 0; l < j; ++l)
        for (std::size_t i = 0; i < M; ++i)
          for (std::size_t k = 0; k < i; ++k)
            if (parted_by((b_[j] - b_[l]).cross(a_[i] - a_[k]))) return true;
    // A flat piece also needs planes across its own.
    return parted_in_plane_of(b_) || parted_in_plane_of(a_);
  }

 private:
  template <std::size_t K>
  bool parted_by_sides_of(const std::array<Vec3, K>& p) const {
    for (std::size_t i = 0; i < (K == 3 ? 1 : K); ++i) {
      const Vec3 &x = p[(i + 1) % K], &y = p[(i + 2) % K], &z = p[(i + 3) % K];
      if (parted_by((y - x).cross(z - x))) return true;
    }
    return false;
  }
  template <std::size_t K>
  bool parted_in_plane_of(const std::array<Vec3, K>& p) const {
    const Vec3 n = (p[1] - p[0]).cross(p[2] - p[0]);
    for (std::size_t i = 0; i < K; ++i)
      for (std::size_t k = 0; k < i; ++k)
        if (parted_by(n.cross(p[i] - p[k]))) return true;
    return false;
  }

  // Is there a plane across this axis that holds the common corners and has the two pieces on its two sides,
  // one of them strictly?
  bool parted_by(const Vec3& axis) const {
    const double margin = margin_ * axis.norm();
    if (!(margin > 0)) return false;
    Range a, b, common;
    for (std::size_t i = 0; i < M; ++i) (common_a_[i] ? common : a).add(axis.dot(a_[i]));
    for (std::size_t j = 0; j < N; ++j)
      if (!common_b_[j]) b.add(axis.dot(b_[j]));
    if (!any_) return a.most + margin < b.least || b.most + margin < a.least;
    if (common.most - common.least > margin) return false;
    const double slack = margin / 1024;  // rounding of corners on the plane
    const auto below = [&](const Range& x, const Range& y) {
      return (x.most <= common.least + slack && common.most + margin < y.least) ||
             (x.most + margin < common.least && common.most <= y.least + slack);
    };
    return below(a, b) || below(b, a);
  }
  struct Range {
    double least = 1e300, most = -1e300;
    void add(double x) { least = x < least ? x : least, most = x > most ? x : most; }
  };

  std::array<Vec3, M> a_;
  std::array<Vec3, N> b_;
  std::array<bool, M> common_a_{};
  std::array<bool, N> common_b_{};
  bool any_ = false;
  double margin_;
};

}  // namespace filmsticking
