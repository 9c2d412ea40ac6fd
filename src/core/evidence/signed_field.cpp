// SPDX-License-Identifier: GPL-3.0-or-later
#include "evidence/signed_field.h"

#include <array>
#include <cmath>
#include <utility>

#include "geometry/parallel.h"

namespace filmsticking {
namespace {

constexpr int kMaxIterations = 300;
// Of the residual, per tetrahedron; only the sign and the rough size of the field matter.
constexpr double kTolerance = 4e-4;

}  // namespace

std::vector<double> signed_field(const TetrahedralMesh& mesh, const FacetEvidence& evidence,
                                 std::vector<double> guess, const Cancel& cancel) {
  const std::size_t n = mesh.size();
  std::vector<double> x = std::move(guess);
  const double total = parallel_sum(n, [&](std::size_t t) {
    const auto& a = evidence.area[t];
    return double{a[0]} + a[1] + a[2] + a[3];
  });
  const double unit = total > 0 ? static_cast<double>(4 * n) / total : 1;
  auto given = [&](std::size_t t) { return mesh.tets.infinite(static_cast<Index>(t)); };
  // With the unknowns scaled by the roots of the diagonal, the matrix has ones on it. The given ones have
  // neither rows nor columns. Single precision is enough for what is added to the guess.
  UnsetVector<std::array<float, 4>> coupling(n);
  UnsetVector<float> root(n), residual(n), change(n), direction(n), image(n), pull(n);
  auto strength = [&](std::size_t t, int k) {
    return kVoteCoupling[evidence.votes[t][k]] * double{evidence.area[t][k]} * unit;
  };
  // The residual that a field would have which is wrong by one everywhere. (What the given outside pulls at,
  // the usual measure, is little for a large cloud: few of its tetrahedra are beside infinite ones.)
  const double scale = parallel_sum(n, [&](std::size_t t) {
    double diagonal = 1e-9;
    for (int k = 0; k < 4; ++k) diagonal += std::abs(strength(t, k));
    if (given(t)) x[t] = -1;
    root[t] = given(t) ? 0 : static_cast<float>(std::sqrt(diagonal));
    return diagonal;
  });
  double rr = parallel_sum(n, [&](std::size_t t) {
    coupling[t] = {0, 0, 0, 0};
    residual[t] = change[t] = direction[t] = image[t] = 0;
    if (root[t] == 0) return 0.0;
    double row = 1e-9 * x[t];
    for (int k = 0; k < 4; ++k) {
      const Index u = mesh.tets.neighbours[t][k];
      const double c = strength(t, k);
      row += std::abs(c) * x[t] - c * x[u];
      if (root[u] > 0) coupling[t][k] = static_cast<float>(c / (static_cast<double>(root[t]) * root[u]));
    }
    residual[t] = static_cast<float>(-row / root[t]);
    return double{residual[t]} * residual[t];
  });
  const double enough = kTolerance * kTolerance * scale;
  if (!(rr > enough)) return x;

  double step = 0, last = 0;
  // Conjugate gradients with both products of an iteration taken at once (Chronopoulos and Gear 1989).
  for (int iteration = 0; iteration < kMaxIterations && rr > enough; ++iteration) {
    cancel();
    const double curvature = parallel_sum(n, [&](std::size_t t) {
      const auto& c = coupling[t];
      const auto& u = mesh.tets.neighbours[t];
      pull[t] = residual[t] - (c[0] * residual[u[0]] + c[1] * residual[u[1]] + c[2] * residual[u[2]] +
                               c[3] * residual[u[3]]);
      return double{residual[t]} * pull[t];
    });
    const double ratio = iteration == 0 ? 0 : rr / last;
    const double slope = iteration == 0 ? curvature : curvature - ratio * rr / step;
    if (!(slope > 0)) break;
    step = rr / slope;
    last = rr;
    const float a = static_cast<float>(step), b = static_cast<float>(ratio);
    rr = parallel_sum(n, [&](std::size_t t) {
      direction[t] = residual[t] + b * direction[t];
      image[t] = pull[t] + b * image[t];
      change[t] += a * direction[t];
      residual[t] -= a * image[t];
      return double{residual[t]} * residual[t];
    });
  }
  parallel_each(n, [&](std::size_t t) {
    if (root[t] > 0) x[t] += double{change[t]} / root[t];
  });
  return x;
}

}  // namespace filmsticking
