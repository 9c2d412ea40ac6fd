// SPDX-License-Identifier: GPL-3.0-or-later
#include "evidence/signed_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "geometry/parallel.h"

namespace filmsticking {
namespace {

constexpr int kMaxIterations = 300;
// Mean residual per tetrahedron at which to stop. Only the sign and the rough size of the field matter.
constexpr double kTolerance = 4e-4;
// Added to the diagonal: a tetrahedron whose facets have no area would leave the matrix singular.
constexpr double kDiagonal = 1e-9;

/// The field's linear system, and conjugate gradients that solve it for the change to the guess. By hand:
/// Eigen's solver would need a wrapper for the matrix, which is not stored, of the same length.
///
/// The unknowns are scaled by the roots of the diagonal, so that the matrix has ones there. The infinite
/// tetrahedra are given: they have neither rows nor columns. Single precision suffices for the change.
class FieldSystem {
 public:
  FieldSystem(const TetrahedralMesh& mesh, const FacetEvidence& evidence, const SiteGeometry& geometry,
              std::vector<double> guess, const std::vector<double>& known)
      : mesh_(mesh),
        evidence_(evidence),
        geometry_(geometry),
        known_(known),
        size_(mesh.size()),
        unit_(one_over_mean_area()),
        field_(std::move(guess)),
        coupling_(size_),
        root_(size_),
        residual_(size_),
        change_(size_),
        direction_(size_),
        image_(size_),
        pull_(size_) {
    const double scale = set_diagonal();
    residual2_ = set_residual();
    enough_ = kTolerance * kTolerance * scale;
  }

  std::vector<double> solve(const Cancel& cancel) {
    if (!(residual2_ > enough_)) return std::move(field_);
    double step = 0, last = 0;
    // Both scalar products of an iteration are taken in one pass (Chronopoulos and Gear 1989).
    for (int iteration = 0; iteration < kMaxIterations && residual2_ > enough_; ++iteration) {
      cancel();
      const double curvature = apply_to_residual();
      const double ratio = iteration == 0 ? 0 : residual2_ / last;
      const double slope = iteration == 0 ? curvature : curvature - ratio * residual2_ / step;
      if (!(slope > 0)) break;
      step = residual2_ / slope;
      last = residual2_;
      residual2_ = advance(static_cast<float>(step), static_cast<float>(ratio));
    }
    parallel_each(size_, [&](std::size_t t) {
      if (root_[t] > 0) field_[t] += double{change_[t]} / root_[t];
    });
    return std::move(field_);
  }

 private:
  double one_over_mean_area() const {
    const double total = parallel_sum(size_, [&](std::size_t t) {
      const auto& a = evidence_.area[t];
      return double{a[0]} + a[1] + a[2] + a[3];
    });
    return total > 0 ? static_cast<double>(4 * size_) / total : 1;
  }

  double strength(std::size_t t, int k) const {
    return kVoteCoupling[evidence_.votes[t][k]] * sampled_area(mesh_, evidence_, geometry_, t, k) * unit_;
  }

  double pull(std::size_t t) const { return known_.empty() ? 0 : known_[t] * unit_; }

  // Returns the squared residual of a field that is wrong by one everywhere. (The usual measure, the pull of
  // the given outside, is small for a large cloud: few of its tetrahedra touch infinite ones.)
  double set_diagonal() {
    return parallel_sum(size_, [&](std::size_t t) {
      const bool given = mesh_.tets.infinite(static_cast<Index>(t));
      double diagonal = kDiagonal + std::abs(pull(t));
      for (int k = 0; k < 4; ++k) diagonal += std::abs(strength(t, k));
      if (given) field_[t] = -1;
      root_[t] = given ? 0 : static_cast<float>(std::sqrt(diagonal));
      return diagonal;
    });
  }

  // Returns the squared residual of the guess.
  double set_residual() {
    return parallel_sum(size_, [&](std::size_t t) {
      coupling_[t] = {0, 0, 0, 0};
      residual_[t] = change_[t] = direction_[t] = image_[t] = 0;
      if (root_[t] == 0) return 0.0;
      double row = (kDiagonal + std::abs(pull(t))) * field_[t] - pull(t);
      for (int k = 0; k < 4; ++k) {
        const Index u = mesh_.tets.neighbours[t][k];
        const double c = strength(t, k);
        row += std::abs(c) * field_[t] - c * field_[u];
        if (root_[u] > 0)
          coupling_[t][k] = static_cast<float>(c / (static_cast<double>(root_[t]) * root_[u]));
      }
      residual_[t] = static_cast<float>(-row / root_[t]);
      return double{residual_[t]} * residual_[t];
    });
  }

  double apply_to_residual() {
    return parallel_sum(size_, [&](std::size_t t) {
      const auto& c = coupling_[t];
      const auto& u = mesh_.tets.neighbours[t];
      pull_[t] = residual_[t] - (c[0] * residual_[u[0]] + c[1] * residual_[u[1]] + c[2] * residual_[u[2]] +
                                 c[3] * residual_[u[3]]);
      return double{residual_[t]} * pull_[t];
    });
  }

  double advance(float step, float ratio) {
    return parallel_sum(size_, [&](std::size_t t) {
      direction_[t] = residual_[t] + ratio * direction_[t];
      image_[t] = pull_[t] + ratio * image_[t];
      change_[t] += step * direction_[t];
      residual_[t] -= step * image_[t];
      return double{residual_[t]} * residual_[t];
    });
  }

  const TetrahedralMesh& mesh_;
  const FacetEvidence& evidence_;
  const SiteGeometry& geometry_;
  const std::vector<double>& known_;
  const std::size_t size_;
  const double unit_;
  std::vector<double> field_;
  UnsetVector<std::array<float, 4>> coupling_;
  UnsetVector<float> root_, residual_, change_, direction_, image_, pull_;
  double residual2_ = 0, enough_ = 0;
};

}  // namespace

std::vector<double> signed_field(const TetrahedralMesh& mesh, const FacetEvidence& evidence,
                                 const SiteGeometry& geometry, std::vector<double> guess,
                                 const std::vector<double>& known, const Cancel& cancel) {
  return FieldSystem(mesh, evidence, geometry, std::move(guess), known).solve(cancel);
}

}  // namespace filmsticking
