// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "labelling/mending.h"

namespace filmsticking {

/// A disc of tetrahedra across a tunnel (outside) or through a bridge (inside).
struct Disc {
  Move part;
  double lining;  ///< Of what it is across: lining().
};

/// How far samples line the tunnel that a disc is across, or the bar that it is through. Samples that line it
/// have normals across its axis; around a chance gap in a wall they are along it, and this is negative. It is
/// the sum, over the samples at the disc, of a third less the squared cosine between normal and axis, which
/// is none on average for random normals; uncertain normals count less.
double lining(const Labelling& labelling, const std::vector<Vec3>& sites, const Move& disc);

/// The discs of a label, of tetrahedra narrower than `radius`, that leave fewer handles if they are
/// relabelled and that samples do not line, smallest first. Leaves the labels as they are, and names the
/// pieces.
std::vector<Disc> discs(Mending& mending, const std::vector<Vec3>& sites, double radius, char label);

}  // namespace filmsticking
