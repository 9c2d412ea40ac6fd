// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/plane_triangulation.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cstddef>

namespace filmsticking {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
enum class Side { Unknown, Outside, Inside };
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<Side, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>, CGAL::No_constraint_intersection_tag>;

Vec3 area_vector(const std::vector<Vec3>& corners) {
  Vec3 area = Vec3::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i)
    area += (corners[i] - corners[0]).cross(corners[(i + 1) % corners.size()] - corners[0]);
  return area;
}

// False: edges cross, or two corners are one.
bool insert(Triangulation& plane, const std::vector<Vec3>& corners, const Vec3& normal) {
  const Vec3 u = normal.unitOrthogonal(), v = normal.cross(u);
  std::vector<Triangulation::Vertex_handle> at;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 p = corners[i] - corners[0];
    at.push_back(plane.insert({p.dot(u), p.dot(v)}));
    at.back()->info() = static_cast<Index>(i);
  }
  if (plane.number_of_vertices() != corners.size() || plane.dimension() < 2) return false;
  try {
    for (std::size_t i = 0; i < corners.size(); ++i)
      plane.insert_constraint(at[i], at[(i + 1) % corners.size()]);
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    return false;
  }
  return true;
}

void mark_sides(Triangulation& plane) {
  for (auto face = plane.all_faces_begin(); face != plane.all_faces_end(); ++face)
    face->info() = Side::Unknown;
  plane.infinite_face()->info() = Side::Outside;
  std::vector<Triangulation::Face_handle> open{plane.infinite_face()};
  while (!open.empty()) {  // ends: every face is marked once
    const auto face = open.back();
    open.pop_back();
    for (int k = 0; k < 3; ++k) {
      const auto other = face->neighbor(k);
      if (other->info() != Side::Unknown) continue;
      const bool crosses = plane.is_constrained({face, k});
      other->info() = crosses == (face->info() == Side::Outside) ? Side::Inside : Side::Outside;
      open.push_back(other);
    }
  }
}

// Every edge of the polygon has one face, in its direction.
bool fills(const std::vector<Corners>& faces, std::size_t corners) {
  std::size_t edges = 0;
  for (const Corners& t : faces)
    for (int k = 0; k < 3; ++k)
      edges += static_cast<std::size_t>(t[(k + 1) % 3]) == (static_cast<std::size_t>(t[k]) + 1) % corners;
  return faces.size() + 2 == corners && edges == corners;
}

}  // namespace

std::vector<Corners> plane_triangulation(const std::vector<Vec3>& corners) {
  const Vec3 area = area_vector(corners);
  Triangulation plane;
  if (!(area.stableNorm() > 0) || !insert(plane, corners, area.stableNormalized())) return {};
  mark_sides(plane);
  std::vector<Corners> faces;
  for (auto face = plane.finite_faces_begin(); face != plane.finite_faces_end(); ++face)
    if (face->info() == Side::Inside)
      faces.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  for (Corners& t : faces) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::sort(faces.begin(), faces.end());
  if (!fills(faces, corners.size())) faces.clear();
  return faces;
}

}  // namespace filmsticking
