// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "surface.h"

namespace filmsticking::mesh_report {

/// A mesh against the true surface, both moved and scaled so that the truth's box has its centre at the
/// origin and longest side 1. Measured at points spread evenly over the area of each, to the other.
struct TruthDistances {
  double chamfer_e3 = 0;          ///< mean of the two mean distances, x 1000
  double f_score = 0;             ///< percent: harmonic mean of the two shares of points nearer than kNear
  double normal_consistency = 0;  ///< percent: mean of the two mean |cosines| with the nearest face's normal
  double turned_over =
      0;  ///< percent of the mesh whose normal opposes the nearest one of the truth, at most 50
  double hausdorff = 0;  ///< the largest distance that a point had
};

constexpr double kNear = 0.005;
constexpr std::size_t kDefaultSamples = 100'000, kMostSamples = 1'000'000;

/// With `samples` points on each, always the same ones for the same surfaces. None where one of the two has
/// no area, or the truth no extent.
std::optional<TruthDistances> truth_distances(const Surface& mesh, const Surface& truth,
                                              std::size_t samples = kDefaultSamples);

}  // namespace filmsticking::mesh_report
