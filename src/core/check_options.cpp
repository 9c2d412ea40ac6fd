// SPDX-License-Identifier: GPL-3.0-or-later
#include "check_options.h"

#include <cmath>
#include <vector>

#include "failure.h"
#include "geometry/triangle_adjacency.h"

namespace filmsticking {
namespace {

void require(bool holds, const char* complaint) {
  if (!holds) throw Failure(Status::InvalidOptions, complaint);
}

bool is_closed_manifold(const Mesh& mesh) {
  for (const Point& p : mesh.positions)
    for (double x : p)
      if (!std::isfinite(x)) return false;
  const std::vector<Corners> triangles(mesh.triangles.begin(), mesh.triangles.end());
  return check_manifold(triangles, static_cast<Index>(mesh.positions.size())).ok();
}

}  // namespace

void check_options(const Options& options, std::size_t points) {
  require(options.virtual_sites >= Options::kAdaptiveVirtualSites,
          "the number of virtual sites must not be negative");
  require(options.max_steps >= 1, "at least one film step is needed");
  require(options.max_rounds >= 0, "the number of rounds must not be negative");
  require(options.threads >= 0, "the number of threads must not be negative");
  require(std::isfinite(options.max_hole) && options.max_hole >= 0,
          "the largest hole to close must be a finite length that is not negative");
  require(options.max_memory >= 0, "the memory allowed must not be negative");
  require(!options.viewpoints || options.viewpoints->size() == points,
          "the number of viewpoints must be that of the points");
  if (options.view_direction) {
    const Point& d = *options.view_direction;
    const double length = std::hypot(d[0], d[1], d[2]);
    require(length > 0 && std::isfinite(length), "the view direction must be finite and not zero");
  }
  if (method_of(options) != Method::Film || film_start_of(options) != FilmStart::Given) return;
  if (!options.guiding_surface || !is_closed_manifold(*options.guiding_surface))
    throw Failure(Status::InvalidGuidingSurface);
}

}  // namespace filmsticking
