// SPDX-License-Identifier: GPL-3.0-or-later
// What labels cost, and the price of everything that is decided on labels.
#pragma once

#include "labelling/labelling.h"
#include "surface/energy.h"

namespace filmsticking {

/// Prices of moves, in sites off the surface. surface_energy() prices the result, in the same unit.
/// docs/constants.md: what each one is from, and what halving and doubling it changes.
struct MovePrices {
  /// Repair: of a handle more. Where a site of a wall's other side pierces it, the repair covers that site
  /// and does not open the wall.
  double new_handle = 20;
  /// Mending: of a tunnel filled, what a handle costs in the energy. A plug has two lids, which the votes are
  /// against where the tunnel is real, and takes a wall away, which they are for then.
  double tunnel = EnergyPrices().complexity;
  /// Mending: of a piece less. Two parts may lie close to each other, so this is little: in a tear the votes
  /// are for a plug, or hardly against it.
  double tear = 0.5;
  /// How much less filling a tunnel is worth for each tetrahedron of a disc where the surface is smooth:
  /// chance gaps are small then, those in noise are not.
  double tunnel_size = 0.05;
  /// How much more, for each unit of lining below none, as far as the surface is smooth: a sample that shows
  /// a gap is two thirds of one. The more there are, the wider is the gap, and the more its disc costs.
  double gap = 0.6;
  /// Of a bridge cut and of a shard joined, and how much more on a rough surface: of noise, where evidence is
  /// weak. There is no chance bridge between smooth surfaces, and two parts may lie close to each other.
  double bridge = 1, bridge_rough = 2, shard = 0.5, shard_rough = 1.5;
};

/// Of labels: facets of the surface, labels against the belief, sites off the surface; the Euler
/// characteristic, with the sheets at singular sites taken apart; the surplus pieces and the sites off. The
/// labelling has a census. Linear in the tetrahedra.
Effect energy_of(const Labelling& labelling);

/// Of a move: energy_of() after it less energy_of() before it, but for rounding. Looks only at the move and
/// the stars of its sites. Throws Cancelled.
inline Effect energy_of(Labelling& labelling, const Move& move) { return labelling.effect(move); }

}  // namespace filmsticking
