// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "labelling/labelling.h"

namespace filmsticking {

/// How rough the surface is, by how far its facets face away from the mean around their corners: 0 for a
/// smooth surface, 1 for one of noise.
double roughness(const Labelling& labelling, const std::vector<Vec3>& sites);

}  // namespace filmsticking
