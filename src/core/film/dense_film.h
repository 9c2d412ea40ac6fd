// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "delaunay/tetrahedral_mesh.h"

namespace filmsticking {

/// The film from the bounding sphere to its end, with virtual sites as dense as the width allows (paper,
/// section 4.3): the labels, 1 inside. Inside is what two rules leave, in any order, since both only take:
///  - a tetrahedron leaves if its circumcentre is outside (a film step without weights);
///  - it leaves through a facet to the outside whose smallest empty ball is at least `width` spacings wide. A
///    virtual site fits there, and the tetrahedron that it makes with the facet has its circumcentre outside.
/// The result does not depend on their order, nor on the number of threads.
///
/// `spacing`: per site. `after_step`: if given, the rules run once a step, and it is called with the labels.
std::vector<char> dense_film(const TetrahedralMesh& mesh, const std::vector<Vec3>& sites,
                             const std::vector<double>& spacing, double width,
                             const std::function<void(const std::vector<char>&)>& after_step = {});

}  // namespace filmsticking
