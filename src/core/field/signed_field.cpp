// SPDX-License-Identifier: GPL-3.0-or-later
#include "signed_field.h"

#include <cmath>

#include "parallel.h"

namespace filmsticking {
namespace {

// How much a facet couples its two sides, by votes: 1 the same, -1 opposite.
constexpr double kCoupling[4] = {1.0, 0.3, -0.3, -1.0};
constexpr int kMaxIterations = 300;
constexpr double kTolerance = 1e-3;  // of the residual; only the sign and rough size of the field matter

}  // namespace

std::vector<double> signed_field(const TetrahedralMesh& mesh, const FacetEvidence& evidence) {
  const std::size_t n = mesh.size();
  std::vector<std::array<double, 4>> coupling(n);
  std::vector<double> diagonal(n), x(n, 0), residual(n), direction(n), image(n);
  double total = 0;
  for (std::size_t t = 0; t < n; ++t)
    for (double a : evidence.area[t]) total += a;
  const double unit = total > 0 ? static_cast<double>(4 * n) / total : 1;
  parallel_each(n, [&](std::size_t t) {
    diagonal[t] = 1e-9;
    for (int k = 0; k < 4; ++k) {
      coupling[t][k] = kCoupling[evidence.votes[t][k]] * evidence.area[t][k] * unit;
      diagonal[t] += std::abs(coupling[t][k]);
    }
    if (mesh.tets.infinite(static_cast<Index>(t))) x[t] = -1;
  });
  auto apply = [&](const std::vector<double>& v, std::vector<double>& out) {
    parallel_each(n, [&](std::size_t t) {
      double sum = 0;
      if (!mesh.tets.infinite(static_cast<Index>(t))) {
        sum = diagonal[t] * v[t];
        for (int k = 0; k < 4; ++k) sum -= coupling[t][k] * v[mesh.tets.neighbours[t][k]];
      }
      out[t] = sum;
    });
  };
  // Sums in index order, on one thread: the same for any number of them.
  apply(x, image);
  double rz = 0;
  for (std::size_t t = 0; t < n; ++t) {
    residual[t] = -image[t];
    direction[t] = residual[t] / diagonal[t];
    rz += residual[t] * direction[t];
  }
  const double enough = kTolerance * kTolerance * rz;
  for (int iteration = 0; iteration < kMaxIterations && rz > enough; ++iteration) {
    apply(direction, image);
    double curvature = 0;
    for (std::size_t t = 0; t < n; ++t) curvature += direction[t] * image[t];
    if (!(curvature > 0)) break;
    const double step = rz / curvature;
    double next = 0;
    for (std::size_t t = 0; t < n; ++t) {
      x[t] += step * direction[t];
      residual[t] -= step * image[t];
      next += residual[t] * residual[t] / diagonal[t];
    }
    const double ratio = next / rz;
    rz = next;
    for (std::size_t t = 0; t < n; ++t) direction[t] = residual[t] / diagonal[t] + ratio * direction[t];
  }
  return x;
}

}  // namespace filmsticking
