// SPDX-License-Identifier: GPL-3.0-or-later
#include "labelling/mend.h"

#include <algorithm>

#include "labelling/bars.h"
#include "labelling/caps.h"
#include "labelling/discs.h"
#include "labelling/energy.h"
#include "labelling/mending.h"
#include "labelling/plugs.h"
#include "labelling/roughness.h"
#include "labelling/ways.h"

namespace filmsticking {
namespace {

// All radii are in the largest spacing of the corners.
// Of tetrahedra outside that may be part of a plug, the narrowest first. Two sides of a thin wall have gaps
// of up to four spacings at the same place.
constexpr double kPlugRadii[] = {1, 1.25, 1.5, 1.75, 2, 2.5, 3, 4};
// Of facets of a cap. Wide tetrahedra have narrow facets where one side of a wall has a large gap and samples
// of the other fill half of it.
constexpr double kCapRadii[] = {0.5, 0.75, 1};
// Of tetrahedra of ways between pieces.
constexpr double kWayRadii[] = {1, 1.25, 1.5, 1.75, 2, 2.5, 3, 4};
// Of tetrahedra outside that discs may fill a tunnel with.
constexpr double kTunnelRadii[] = {1, 1.5, 2, 3};
// Of tetrahedra inside that may be a bridge: the inside of a wall is as narrow.
constexpr double kBridgeRadii[] = {1, 1.5};
// Of facets that span a mouth and do not line it, the widest first: facets between random samples of a
// surface have up to two.
constexpr double kBarRadii[] = {3, 2.5, 2, 1.75, 1.5, 1.25, 1};
constexpr MovePrices kPrices;

// There is no handle and no piece that a mend could take away.
bool is_whole(Mending& mending) { return mending.name_pieces() <= 2 && mending.handles() == 0; }

void try_plugs(Mending& mending) {
  double earlier = 0;
  for (const double radius : kPlugRadii) {
    if (mending.labelling.spent()) return;
    mending.try_all(plugs(mending.labelling, radius, earlier), 0, {kPrices.tunnel, kPrices.tear});
    earlier = radius;
  }
}

// Joins shards of one label to other pieces.
void try_ways(Mending& mending, const std::vector<Vec3>& sites, double radius, char label, double rough) {
  if (mending.pieces.count() <= 2 || mending.labelling.spent()) return;
  const MendTerms shard{0, kPrices.shard + rough * kPrices.shard_rough, 0, true};
  mending.try_all(ways(mending.labelling, mending.pieces, sites, radius, label), label, shard);
  mending.name_pieces();
}

// Fills tunnels (label 0) or cuts bridges (1).
void try_discs(Mending& mending, const std::vector<Vec3>& sites, double radius, char label, double rough) {
  if (mending.handles() == 0 || mending.labelling.spent()) return;
  const MendTerms tunnel{kPrices.tunnel, 0, (1 - rough) * kPrices.tunnel_size, true},
      bridge{kPrices.bridge + rough * kPrices.bridge_rough, 0, 0, true};
  for (const Disc& disc : discs(mending, sites, radius, label)) {
    MendTerms terms = label ? bridge : tunnel;
    if (!label) terms.tunnel += (1 - rough) * kPrices.gap * std::max(0.0, -disc.lining);
    mending.try_all({disc.part}, label, terms);
  }
  mending.name_pieces();
}

void fill_gaps(Mending& mending, const std::vector<Vec3>& sites) {
  Labelling& labelling = mending.labelling;
  for (const double radius : kCapRadii)
    if (!labelling.spent())
      mending.try_all(caps(labelling, sites, radius), 0, {kPrices.tunnel, kPrices.tear, 0, true});
  if (is_whole(mending)) return;
  const double rough = roughness(labelling, sites);
  for (const char label : {char{0}, char{1}})
    for (const double radius : kWayRadii) try_ways(mending, sites, radius, label, rough);
  for (const double radius : kTunnelRadii) try_discs(mending, sites, radius, 0, rough);
  for (const double radius : kBridgeRadii) try_discs(mending, sites, radius, 1, rough);
}

void try_bars(Mending& mending, const std::vector<Vec3>& sites) {
  if (mending.name_pieces() < 3) return;
  for (const double radius : kBarRadii)
    if (!mending.labelling.spent())
      mending.try_all(bars(mending.labelling, mending.pieces, sites, radius), 1,
                      {kPrices.tunnel, kPrices.tear, 0, true});
}

}  // namespace

void mend(Labelling& labelling, const std::vector<Vec3>& sites) {
  Mending mending(labelling);
  if (is_whole(mending)) return;
  fill_gaps(mending, sites);
  try_bars(mending, sites);
}

std::int64_t plug_gaps(Labelling& labelling) {
  Mending mending(labelling);
  const auto mends = [&] { return labelling.counts.tunnels + labelling.counts.tears; };
  const std::int64_t before = mends();
  if (!is_whole(mending)) try_plugs(mending);
  return mends() - before;
}

}  // namespace filmsticking
