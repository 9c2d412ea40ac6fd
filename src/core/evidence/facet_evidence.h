// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "delaunay/tetrahedral_mesh.h"
#include "points/site_geometry.h"

namespace filmsticking {

/// How a facet couples its two sides, by its votes: positive makes them equal, negative opposite; 1 is full
/// strength.
constexpr double kVoteCoupling[4] = {1.0, 0.3, -0.3, -1.0};

/// Evidence for each Delaunay facet, from the sites alone. Entry [t][k] is the facet of tetrahedron t
/// opposite its corner k, equal from both sides. Facets with the infinite vertex have zeros.
struct FacetEvidence {
  UnsetVector<std::array<float, 4>> area;
  /// 0 to 3, one per corner. A corner votes for the facet if the dual Voronoi edge crosses the corner's
  /// tangent plane within two spacings: the facet belongs to the corner's local triangulation (after Co3Ne,
  /// Boltcheva and Levy 2017).
  UnsetVector<std::array<signed char, 4>> votes;
  /// The price of a facet on the surface: area x (price by votes + price by angle). The price by angle is the
  /// "surface quality" of Labatut et al. 2009: 1 - the smaller cosine of the angles between the facet and its
  /// tetrahedra's circumspheres. A high value is bad.
  UnsetVector<std::array<float, 4>> cost;
};

/// Most samples that a facet speaks for. A facet over an opening is far larger, and no sample lies on it: by
/// its area it would make what is inside equal to the outside, and draw a lid in. With 1, lids are as flat,
/// and 117 instead of 120 of 159 models have the right topology.
constexpr double kMostSamples = 4;

/// The area of facet k of t, at most that of kMostSamples samples.
double sampled_area(const TetrahedralMesh& mesh, const FacetEvidence& evidence, const SiteGeometry& geometry,
                    std::size_t t, int k);

/// `mesh`: the Delaunay tetrahedra of `sites`.
FacetEvidence facet_evidence(const TetrahedralMesh& mesh, const std::vector<Vec3>& sites,
                             const SiteGeometry& geometry);

}  // namespace filmsticking
