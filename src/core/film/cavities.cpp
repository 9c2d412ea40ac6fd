// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/cavities.h"

#include <algorithm>
#include <utility>

#include "evidence/ball.h"
#include "film/film_step.h"
#include "geometry/disjoint_sets.h"
#include "geometry/parallel.h"

namespace filmsticking {
namespace {

// [tetrahedron]: its room, or kNone. Returns the number of rooms.
Index find_rooms(const TetrahedralMesh& mesh, const std::vector<Vec3>& sites,
                 const std::vector<double>& spacing, const std::vector<char>& inside,
                 std::vector<Index>& room) {
  DisjointSets joined(mesh.size());
  std::vector<char> wide(mesh.size(), 0);
  parallel_each(mesh.size(), [&](std::size_t t) {
    for (int k = 0; inside[t] && k < 4; ++k) {
      const Index u = mesh.tets.neighbours[t][k];
      if (!inside[u] || facet_width(mesh, sites, spacing, static_cast<Index>(t), k) < kRoomWidth) continue;
      wide[t] = 1;
      joined.unite(static_cast<Index>(t), u);
    }
  });
  const Index rooms = joined.number(room);
  for (std::size_t t = 0; t < room.size(); ++t)
    if (!wide[t]) room[t] = kNone;
  return rooms;
}

}  // namespace

std::vector<char> cavities(const TetrahedralMesh& mesh, const std::vector<Vec3>& sites,
                           const std::vector<double>& spacing, const std::vector<char>& inside,
                           const std::vector<char>& sides) {
  std::vector<Index> room;
  const Index rooms = find_rooms(mesh, sites, spacing, inside, room);
  std::vector<std::pair<Index, Index>> walls;  // each room and each of its sites
  for (std::size_t t = 0; t < mesh.size(); ++t)
    for (int k = 0; room[t] != kNone && k < 4; ++k) walls.emplace_back(room[t], mesh.tets.corners[t][k]);
  std::sort(walls.begin(), walls.end());
  walls.erase(std::unique(walls.begin(), walls.end()), walls.end());
  std::vector<Index> missed(static_cast<std::size_t>(rooms), 0);  // sites off the film, less those on it
  for (const auto& [r, v] : walls) missed[r] += sides[v] == kOnFilm ? -1 : 1;
  std::vector<char> cavity(mesh.size(), 0);
  for (std::size_t t = 0; t < mesh.size(); ++t)
    cavity[t] = static_cast<char>(room[t] != kNone && missed[room[t]] > 0);
  return cavity;
}

}  // namespace filmsticking
