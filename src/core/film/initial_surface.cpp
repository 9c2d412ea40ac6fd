// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/initial_surface.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "film/winding_number.h"

namespace filmsticking {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;

Kernel::Point_3 cgal_point(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

}  // namespace

std::function<bool(const Vec3&)> enclosure(const Surface& surface) {
  const auto winding = std::make_shared<const SurfaceWinding>(surface);
  return [winding](const Vec3& x) { return (*winding)(x) > 0.5; };
}

Surface bounding_sphere(const std::vector<Vec3>& sites) {
  double radius = 0;
  for (const Vec3& p : sites) radius = std::max(radius, p.norm());
  // After three subdivisions the icosphere's faces are up to 1 % inside the sphere.
  radius = 1.1 * radius + 1e-3;

  Surface sphere;
  const double g = (1 + std::sqrt(5.0)) / 2;
  sphere.positions = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                      {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  sphere.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                      {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                      {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (int level = 0; level < 3; ++level) {
    std::map<std::pair<Index, Index>, Index> middle;
    auto mid = [&](Index a, Index b) {
      const auto [it, fresh] =
          middle.try_emplace(std::minmax(a, b), static_cast<Index>(sphere.positions.size()));
      if (fresh) sphere.positions.push_back((sphere.positions[a] + sphere.positions[b]) / 2);
      return it->second;
    };
    std::vector<Corners> finer;
    for (const auto& [a, b, c] : sphere.triangles) {
      const Index ab = mid(a, b), bc = mid(b, c), ca = mid(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    sphere.triangles.swap(finer);
    for (Vec3& p : sphere.positions) p.normalize();
  }
  for (Vec3& p : sphere.positions) p *= radius;
  sphere.site.assign(sphere.positions.size(), kNone);
  return sphere;
}

Surface alpha_wrap(const std::vector<Vec3>& sites, double alpha) {
  std::vector<Kernel::Point_3> points;
  points.reserve(sites.size());
  for (const Vec3& p : sites) points.push_back(cgal_point(p));
  CgalMesh wrap;
  // The last number is the wrap's distance from the points: alpha / 30, as CGAL advises.
  CGAL::alpha_wrap_3(points, alpha, alpha / 30, wrap);

  Surface surface;
  std::vector<Index> id(wrap.num_vertices() + wrap.number_of_removed_vertices(), kNone);
  for (auto v : wrap.vertices()) {
    id[v] = static_cast<Index>(surface.positions.size());
    const auto& p = wrap.point(v);
    surface.positions.emplace_back(p.x(), p.y(), p.z());
  }
  for (auto f : wrap.faces()) {
    Corners t{};
    int k = 0;
    for (auto v : wrap.vertices_around_face(wrap.halfedge(f))) t[k++] = id[v];
    surface.triangles.push_back(t);
  }
  surface.site.assign(surface.positions.size(), kNone);
  return surface;
}

}  // namespace filmsticking
