// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/poisson.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Poisson_reconstruction_function.h>
#include <CGAL/property_map.h>

#include <utility>

namespace filmsticking {

std::vector<double> poisson_belief(const TetrahedralMesh& mesh, const std::vector<Vec3>& sites,
                                   const std::vector<Vec3>& normals) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Oriented = std::pair<Kernel::Point_3, Kernel::Vector_3>;
  std::vector<Oriented> points;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const double length = normals[i].norm();
    if (!(length > 0)) continue;
    const Vec3 n = normals[i] / length;
    points.emplace_back(Kernel::Point_3(sites[i].x(), sites[i].y(), sites[i].z()),
                        Kernel::Vector_3(n.x(), n.y(), n.z()));
  }
  if (points.size() < 4) return {};
  CGAL::Poisson_reconstruction_function<Kernel> function(points.begin(), points.end(),
                                                         CGAL::First_of_pair_property_map<Oriented>(),
                                                         CGAL::Second_of_pair_property_map<Oriented>());
  if (!function.compute_implicit_function()) return {};
  std::vector<double> belief(mesh.size(), -1);
  // One thread: CGAL's function caches the tetrahedron that it found last.
  for (std::size_t t = 0; t < mesh.size(); ++t) {
    if (mesh.tets.infinite(static_cast<Index>(t))) continue;
    Vec3 centre = Vec3::Zero();
    for (Index i : mesh.tets.corners[t]) centre += sites[i] / 4;
    if (function(Kernel::Point_3(centre.x(), centre.y(), centre.z())) < 0) belief[t] = 1;
  }
  return belief;
}

}  // namespace filmsticking
