// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "geometry/unset_vector.h"
#include "geometry/vec.h"
#include "geometry/work_limits.h"

namespace filmsticking {

/// The power cells of some sites: who has a cell, and which cells touch. The cell of site i is
/// { x : |x-p_i|^2 - w_i <= |x-p_j|^2 - w_j for all j } (paper, section 4.1); without weights, Voronoi.
struct PowerDiagram {
  std::vector<Vec3> position;    ///< of every site, also of those without a cell
  std::vector<double> weight;    ///< empty: all zero
  std::vector<Index> offset;     ///< neighbours of i: neighbour[offset[i] .. offset[i+1])
  std::vector<Index> neighbour;  ///< ascending for each site; none for a site without a cell
  Index any_site = kNone;        ///< the first with a cell

  bool has_cell(Index i) const { return offset[i + 1] > offset[i]; }

  /// |x-p_i|^2 - w_i
  double power(Index i, const Vec3& x) const {
    const double d = (x - position[i]).squaredNorm();
    return weight.empty() ? d : d - weight[i];
  }

  /// The site whose cell holds x, found by descent from `hint` (any site, or kNone).
  Index owner(const Vec3& x, Index hint) const;
};

/// The Delaunay tetrahedra of some sites, infinite ones included.
struct Tetrahedra {
  UnsetVector<std::array<Index, 4>> corners;     ///< positively oriented; kNone: the vertex at infinity
  UnsetVector<std::array<Index, 4>> neighbours;  ///< across the facet opposite corner k

  std::size_t size() const { return corners.size(); }
  bool infinite(Index t) const {
    const auto& c = corners[t];
    return c[0] == kNone || c[1] == kNone || c[2] == kNone || c[3] == kNone;
  }
};

/// A Delaunay triangulation that sites can leave. Sites at the same place count once.
/// Throws TooManyTetrahedra as soon as its sites so far make more than are allowed: those of sites that lie
/// on two curves grow with the square of their number.
class DelaunayTriangulation {
 public:
  explicit DelaunayTriangulation(std::vector<Vec3> sites, const TriangulationLimits& limits = {});
  ~DelaunayTriangulation();
  DelaunayTriangulation(const DelaunayTriangulation&) = delete;
  DelaunayTriangulation& operator=(const DelaunayTriangulation&) = delete;

  int dimension() const;  ///< 3 unless all sites lie on a plane, a line or a point
  void remove(Index site);
  PowerDiagram voronoi() const;
  Tetrahedra tetrahedra() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The power diagram of weighted sites (regular triangulation). Sites with `present[i] == 0` are left out.
PowerDiagram weighted_power_diagram(const std::vector<Vec3>& sites, const std::vector<double>& weights,
                                    const std::vector<char>& present);

}  // namespace filmsticking
