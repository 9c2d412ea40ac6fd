// SPDX-License-Identifier: GPL-3.0-or-later
#include "signed_field.h"

#include <cmath>
#include <utility>

#include "parallel.h"

namespace filmsticking {
namespace {

constexpr int kMaxIterations = 300;
// Of the residual, per tetrahedron; only the sign and the rough size of the field matter.
constexpr double kTolerance = 4e-4;

}  // namespace

std::vector<double> signed_field(const TetrahedralMesh& mesh, const FacetEvidence& evidence,
                                 std::vector<double> guess, const Cancel& cancel) {
  const std::size_t n = mesh.size();
  std::vector<std::array<float, 4>> coupling(n);
  std::vector<double> diagonal(n), x = std::move(guess), residual(n), direction(n), image(n);
  const double total = parallel_sum(n, [&](std::size_t t) {
    const auto& a = evidence.area[t];
    return double{a[0]} + a[1] + a[2] + a[3];
  });
  const double unit = total > 0 ? static_cast<double>(4 * n) / total : 1;
  auto given = [&](std::size_t t) { return mesh.tets.infinite(static_cast<Index>(t)); };
  parallel_each(n, [&](std::size_t t) {
    diagonal[t] = 1e-9;
    for (int k = 0; k < 4; ++k) {
      coupling[t][k] = static_cast<float>(kVoteCoupling[evidence.votes[t][k]] * evidence.area[t][k] * unit);
      diagonal[t] += std::abs(coupling[t][k]);
    }
    if (given(t)) x[t] = -1;
  });
  auto row = [&](const std::vector<double>& v, std::size_t t) {
    double sum = diagonal[t] * v[t];
    for (int k = 0; k < 4; ++k) sum -= coupling[t][k] * v[mesh.tets.neighbours[t][k]];
    return sum;
  };
  // The residual that a field would have which is wrong by one everywhere. (What the given outside pulls at,
  // the usual measure, is little for a large cloud: few of its tetrahedra are beside infinite ones.)
  const double scale = parallel_sum(n, [&](std::size_t t) { return diagonal[t]; });
  double rz = parallel_sum(n, [&](std::size_t t) {
    residual[t] = given(t) ? 0 : -row(x, t);
    direction[t] = residual[t] / diagonal[t];
    return residual[t] * direction[t];
  });
  const double enough = kTolerance * kTolerance * scale;
  for (int iteration = 0; iteration < kMaxIterations && rz > enough; ++iteration) {
    cancel();
    const double curvature = parallel_sum(n, [&](std::size_t t) {
      image[t] = given(t) ? 0 : row(direction, t);
      return direction[t] * image[t];
    });
    if (!(curvature > 0)) break;
    const double step = rz / curvature;
    const double next = parallel_sum(n, [&](std::size_t t) {
      x[t] += step * direction[t];
      residual[t] -= step * image[t];
      return residual[t] * residual[t] / diagonal[t];
    });
    const double ratio = next / rz;
    rz = next;
    parallel_each(n, [&](std::size_t t) { direction[t] = residual[t] / diagonal[t] + ratio * direction[t]; });
  }
  return x;
}

}  // namespace filmsticking
