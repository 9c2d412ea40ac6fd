// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "filmsticking/types.h"

namespace filmsticking::bench {

/// Whether `name` is one of the generated shapes "sphere", "torus" or "slab:K", and not a file.
bool is_shape(const std::string& name);

/// A closed, outward mesh: the sphere of radius 1 (genus 0), the torus of radii 1 and 0.4 (genus 1), or the
/// slab:K, a plate of 1 by 1 whose thickness is K spacings, where `points` of them on its whole area have the
/// spacing sqrt(area / points). Throws std::invalid_argument for a K that is not positive and finite.
Mesh make_shape(const std::string& name, std::int64_t points);

}  // namespace filmsticking::bench
