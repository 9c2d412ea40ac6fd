// SPDX-License-Identifier: GPL-3.0-or-later
#include "cloud_files.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "clouds/make_cloud.h"
#include "clouds/random.h"
#include "clouds/shapes.h"
#include "io/formats.h"
#include "io/io_error.h"

namespace filmsticking::bench {
namespace {

std::vector<Point> finite_points(const std::vector<Point>& points) {
  std::vector<Point> finite;
  std::copy_if(points.begin(), points.end(), std::back_inserter(finite), [](const Point& p) {
    return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
  });
  return finite;
}

}  // namespace

Mesh read_input(const Input& input, std::int64_t points) {
  if (input.path.empty()) return make_shape(input.name, points);
  const pcl::PolygonMesh model = io::read_model(input.path);
  if (io::size_of(model.cloud) == 0) throw io::IoError("there are no points in it");
  return {io::positions_of(model.cloud), io::triangles_of(model.polygons)};
}

Row cloud_row(const Input& input, const CloudSpec& spec) {
  Row row;
  row.set("shape", input.name);
  row.set("kind", spec.kind());
  row.set("points", std::to_string(spec.points));
  row.set("seed", std::to_string(spec.seed));
  return row;
}

CloudFiles prepare_cloud(const Input& input, const CloudSpec& spec, bool thin_clouds,
                         const std::string& folder) {
  CloudFiles files{folder + "/cloud.ply", "", cloud_row(input, spec)};
  std::filesystem::create_directories(folder);
  try {
    const Mesh mesh = read_input(input, spec.points);
    std::vector<Point> points;
    if (mesh.triangles.empty()) {
      points = finite_points(mesh.positions);
      const bool thin = thin_clouds && static_cast<std::int64_t>(points.size()) > spec.points;
      if (thin) {
        Random random(spec.seed);
        random.shuffle(points);
        points.resize(static_cast<std::size_t>(spec.points));
      }
      files.row.set("kind", thin ? "thinned" : "as it is");
      files.row.set("points", std::to_string(points.size()));
    } else {
      files.truth = input.path;
      if (input.path.empty() || is_depth(spec.sampling)) {
        files.truth = folder + "/truth.ply";
        const Mesh truth = sampled_part(mesh, spec);
        io::write_mesh(files.truth, io::make_cloud(truth.positions), truth.triangles);
      }
      points = make_cloud(mesh, spec);
      files.row.set("points", std::to_string(points.size()));
    }
    io::write_mesh(files.cloud, io::make_cloud(points), {});
  } catch (const io::IoError& error) {
    throw std::runtime_error(input.name + ": " + error.what());
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(input.name + ": " + error.what());
  }
  return files;
}

}  // namespace filmsticking::bench
