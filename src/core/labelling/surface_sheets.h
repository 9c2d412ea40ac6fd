// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "delaunay/tetrahedral_mesh.h"

namespace filmsticking {

/// What the surface between the two labels of tetrahedra is like at a site.
enum class Sheets : char {
  None,  ///< the site is not on it
  Disc,  ///< one disc: the site's tetrahedra of either label are connected through facets at the site
  Other  ///< several sheets, or so many facets that the search leaves it open
};

/// [site]: found from the surface's facets alone, which are far fewer than the tetrahedra.
std::vector<Sheets> surface_sheets(const TetrahedralMesh& mesh, const std::vector<char>& inside,
                                   std::size_t sites);

}  // namespace filmsticking
