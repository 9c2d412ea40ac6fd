// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "geometry/unset_vector.h"
#include "geometry/vec.h"
#include "geometry/work_limits.h"

namespace filmsticking {

/// The power cells of sites: which sites have a cell, and which cells touch. The cell of site i is
/// { x : |x-p_i|^2 - w_i <= |x-p_j|^2 - w_j for all j } (paper, section 4.1); without weights, Voronoi.
struct PowerDiagram {
  std::vector<Vec3> position;    ///< per site, with or without a cell
  std::vector<double> weight;    ///< per site; empty if all are zero
  std::vector<Index> offset;     ///< neighbours of i: neighbour[offset[i] .. offset[i+1])
  std::vector<Index> neighbour;  ///< ascending for each site; none for a site without a cell
  Index any_site = kNone;        ///< the first site that has a cell

  bool has_cell(Index i) const { return offset[i + 1] > offset[i]; }

  /// |x-p_i|^2 - w_i
  double power(Index i, const Vec3& x) const {
    const double d = (x - position[i]).squaredNorm();
    return weight.empty() ? d : d - weight[i];
  }

  /// The site whose cell contains x, or kNone if no site has a cell. `hint`: a site near x, or kNone.
  Index owner(const Vec3& x, Index hint) const;
};

/// Delaunay tetrahedra, infinite ones included.
struct Tetrahedra {
  UnsetVector<std::array<Index, 4>> corners;     ///< positively oriented; kNone is the infinite vertex
  UnsetVector<std::array<Index, 4>> neighbours;  ///< across the facet opposite corner k

  std::size_t size() const { return corners.size(); }
  bool infinite(Index t) const {
    const auto& c = corners[t];
    return c[0] == kNone || c[1] == kNone || c[2] == kNone || c[3] == kNone;
  }
};

/// A Delaunay triangulation from which sites can be removed. Sites at the same place count once. The
/// constructor throws TooManyTetrahedra as soon as the sites inserted so far make more than the limit: on two
/// curves their number grows with the square of the number of sites.
class DelaunayTriangulation {
 public:
  explicit DelaunayTriangulation(std::vector<Vec3> sites, const TriangulationLimits& limits = {});
  ~DelaunayTriangulation();
  DelaunayTriangulation(const DelaunayTriangulation&) = delete;
  DelaunayTriangulation& operator=(const DelaunayTriangulation&) = delete;

  int dimension() const;  ///< 3, or less if all sites lie on a plane, a line or a point
  void remove(Index site);
  PowerDiagram voronoi() const;
  Tetrahedra tetrahedra() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The power diagram of weighted sites, by CGAL's regular triangulation. Leaves out sites with present[i] ==
/// 0.
PowerDiagram weighted_power_diagram(const std::vector<Vec3>& sites, const std::vector<double>& weights,
                                    const std::vector<char>& present);

}  // namespace filmsticking
