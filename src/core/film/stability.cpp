// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/stability.h"

#include "film/power_complex.h"
#include "geometry/parallel.h"

namespace filmsticking {

std::vector<float> site_stability(const TetrahedralMesh& mesh, const std::vector<Vec3>& sites,
                                  const std::vector<char>& inside) {
  std::vector<char> beside(mesh.size(), 0);  // [tetrahedron]: has it a facet of the surface?
  parallel_each(mesh.size(), [&](std::size_t t) {
    for (const Index u : mesh.tets.neighbours[t])
      if (inside[u] != inside[t]) beside[t] = 1;
  });
  const UnsetVector<Index> flow = flow_map(mesh, sites, beside);
  const auto stays = [&](std::size_t t) { return inside[flow[t]] == inside[t]; };
  std::vector<int> facets(sites.size(), 0), stable(sites.size(), 0);
  for (std::size_t t = 0; t < mesh.size(); ++t) {
    if (!inside[t] || !beside[t]) continue;
    for (int k = 0; k < 4; ++k) {
      const auto u = static_cast<std::size_t>(mesh.tets.neighbours[t][k]);
      if (inside[u]) continue;
      const int kept = stays(t) && stays(u) ? 1 : 0;
      for (const int i : kFacet[k]) {
        const Index v = mesh.tets.corners[t][i];
        ++facets[v], stable[v] += kept;
      }
    }
  }
  std::vector<float> shares(sites.size(), 1);
  for (std::size_t v = 0; v < shares.size(); ++v)
    if (facets[v] > 0) shares[v] = static_cast<float>(stable[v]) / static_cast<float>(facets[v]);
  return shares;
}

}  // namespace filmsticking
