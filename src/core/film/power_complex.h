// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "delaunay/tetrahedral_mesh.h"
#include "geometry/work_limits.h"

namespace filmsticking {

/// The regular triangulation of weighted sites, which is dual to their power diagram (paper, section 4.1),
/// with the orthocentres of its tetrahedra and a search for the tetrahedron at a place. Without weights:
/// Delaunay, Voronoi, circumcentres. Immutable.
class PowerComplex {
 public:
  /// Triangulates. `weights`: per site, or empty if all are zero. A site that another one hides has no
  /// tetrahedron. Throws TooManyTetrahedra and Cancelled.
  PowerComplex(std::vector<Vec3> sites, std::vector<double> weights, const TriangulationLimits& limits);

  /// Takes Delaunay tetrahedra of the sites as they are.
  PowerComplex(std::vector<Vec3> sites, Tetrahedra tets);

  const std::vector<Vec3>& sites() const { return sites_; }
  const Tetrahedra& tetrahedra() const { return tets_; }
  std::size_t size() const { return tets_.size(); }
  const Vec3& orthocentre(std::size_t t) const { return centre_[t]; }  ///< Of a finite tetrahedron.
  /// The tetrahedron has no thickness beyond the sites' perturbation: its orthocentre is noise.
  bool flat(std::size_t t) const { return flat_[t] != 0; }

  /// The tetrahedron at x, an infinite one outside the hull. `near`: a site near x, or any. The walk ends: in
  /// a regular triangulation each step lowers the power of x (Edelsbrunner 1989), up to rounding; its length
  /// is bounded for that.
  Index locate(const Vec3& x, Index near) const;
  /// [tetrahedron]: the one at its orthocentre, so that iterated film steps search once. Computed at the
  /// first call, which must not run beside another.
  const UnsetVector<Index>& flow() const;

 private:
  void describe();

  std::vector<Vec3> sites_;
  std::vector<double> weights_;
  Tetrahedra tets_;
  UnsetVector<Vec3> centre_;
  UnsetVector<char> flat_;
  std::vector<Index> seed_;  // [site]: a tetrahedron at it, or kNone
  Index any_ = kNone;        // a finite tetrahedron
  mutable UnsetVector<Index> flow_;
};

/// Where a film step without weights takes each tetrahedron: the one that contains its circumcentre. Infinite
/// ones stay. The circumradius rises along this map, so iterating it ends, at infinity or at a *maximum*, a
/// tetrahedron that contains its own circumcentre (Giesen and John, "The flow complex", 2003).
/// `wanted`: leaves the others unset; empty: all.
UnsetVector<Index> flow_map(const TetrahedralMesh& mesh, const std::vector<Vec3>& sites,
                            const std::vector<char>& wanted = {});

}  // namespace filmsticking
