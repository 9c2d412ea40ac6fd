// SPDX-License-Identifier: GPL-3.0-or-later
#include "deviation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/io_error.h"

namespace filmsticking::scene {
namespace {

using mesh_report::Vec3;

Vec3 vec3(const Point& p) { return {p[0], p[1], p[2]}; }

mesh_report::Surface surface_of(const pcl::PolygonMesh& mesh) {
  mesh_report::Surface surface = mesh_report::make_surface(mesh);
  if (surface.triangles.empty()) throw io::IoError("there is no face with finite corners in it");
  return surface;
}

}  // namespace

// In the reference's unit box: large coordinates would cost digits.
Deviation::Deviation(const pcl::PolygonMesh& reference)
    : frame_(mesh_report::frame_of(surface_of(reference).positions)),
      surface_(frame_.to_unit(surface_of(reference))),
      distance_(surface_) {}

std::vector<double> Deviation::of_points(const std::vector<Point>& points) const {
  std::vector<double> distances(points.size(), std::numeric_limits<double>::quiet_NaN());
  std::vector<Vec3> usable;
  std::vector<std::size_t> origin;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (mesh_report::usable(points[i])) {
      usable.push_back(frame_.to_unit(vec3(points[i])));
      origin.push_back(i);
    }
  const std::vector<mesh_report::Nearest> nearest = distance_.from(usable);
  for (std::size_t i = 0; i < usable.size(); ++i) distances[origin[i]] = nearest[i].distance * frame_.side;
  return distances;
}

std::vector<double> Deviation::of_faces(const pcl::PolygonMesh& mesh) const {
  const std::vector<Point> positions = io::positions_of(mesh.cloud);
  const std::vector<Triangle> triangles = io::triangles_of(mesh.polygons);
  std::vector<Point> middles;
  middles.reserve(triangles.size());
  for (const Triangle& t : triangles) {
    Point middle{};
    for (int k = 0; k < 3; ++k)
      middle[k] = positions[t[0]][k] / 3 + positions[t[1]][k] / 3 + positions[t[2]][k] / 3;
    middles.push_back(middle);
  }
  std::vector<double> faces = of_points(middles);
  const std::vector<double> corners = of_points(positions);
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (const std::int32_t corner : triangles[f])
      // Written so that a NaN of either is kept.
      if (!(corners[corner] <= faces[f])) faces[f] = std::isnan(faces[f]) ? faces[f] : corners[corner];
  return faces;
}

}  // namespace filmsticking::scene
