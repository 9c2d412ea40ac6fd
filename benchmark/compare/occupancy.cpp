// SPDX-License-Identifier: GPL-3.0-or-later
#include "occupancy.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstring>
#include <stdexcept>

#include "io/files.h"
#include "io/io_error.h"

namespace filmsticking::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace pmp = CGAL::Polygon_mesh_processing;

/// Empty if it is not closed or not manifold.
SurfaceMesh to_solid(const Mesh& mesh) {
  std::vector<Kernel::Point_3> places;
  std::vector<std::array<std::size_t, 3>> faces;
  for (const Point& p : mesh.positions) places.emplace_back(p[0], p[1], p[2]);
  for (const Triangle& t : mesh.triangles)
    faces.push_back(
        {static_cast<std::size_t>(t[0]), static_cast<std::size_t>(t[1]), static_cast<std::size_t>(t[2])});
  SurfaceMesh solid;
  if (pmp::is_polygon_soup_a_polygon_mesh(faces)) pmp::polygon_soup_to_polygon_mesh(places, faces, solid);
  return CGAL::is_closed(solid) ? solid : SurfaceMesh();
}

}  // namespace

std::vector<Probe> read_probes(const std::string& path) {
  using Record = std::array<float, 4>;
  try {
    const std::string bytes = io::read_file(path);
    if (bytes.empty() || bytes.size() % sizeof(Record) != 0)
      throw io::IoError("it is not made of four float32 a probe");
    std::vector<Probe> probes;
    for (std::size_t at = 0; at < bytes.size(); at += sizeof(Record)) {
      Record r{};
      std::memcpy(r.data(), bytes.data() + at, sizeof(Record));
      probes.push_back({{r[0], r[1], r[2]}, r[3] > 0.5F});
    }
    return probes;
  } catch (const io::IoError& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

std::optional<Overlap> overlap(const Mesh& mesh, const std::vector<Probe>& probes) {
  const SurfaceMesh solid = to_solid(mesh);
  if (solid.number_of_faces() == 0) return std::nullopt;
  const CGAL::Side_of_triangle_mesh<SurfaceMesh, Kernel> side(solid);
  double truth = 0, found = 0, both = 0;
  for (const Probe& probe : probes) {
    const bool inside = side({probe.place[0], probe.place[1], probe.place[2]}) != CGAL::ON_UNBOUNDED_SIDE;
    truth += probe.inside, found += inside, both += probe.inside && inside;
  }
  if (!(truth > 0)) return std::nullopt;
  return Overlap{both / (truth + found - both), (truth - both) / truth, (found - both) / truth};
}

}  // namespace filmsticking::bench
