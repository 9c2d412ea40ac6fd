// SPDX-License-Identifier: GPL-3.0-or-later
// The time of each stage of the core alone, on the results of the stages before it for points on a torus.
// "Time" is wall time, "CPU" the time of all threads together.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "delaunay/delaunay.h"
#include "delaunay/regular.h"
#include "evidence/ball.h"
#include "evidence/facet_evidence.h"
#include "evidence/signed_field.h"
#include "film/dense_film.h"
#include "film/power_complex.h"
#include "film/winding_number.h"
#include "geometry/nearest.h"
#include "geometry/parallel.h"
#include "geometry/triangle_adjacency.h"
#include "labelling/labelling.h"
#include "labelling/minimum_cut.h"
#include "labelling/reach.h"
#include "labelling/repair.h"
#include "points/site_set.h"
#include "support/clouds.h"
#include "surface/orientation.h"
#include "surface/surface_quality.h"

namespace filmsticking {
namespace {

/// The results of every stage of the default pipeline, up to the surface.
class Stages {
 public:
  explicit Stages(int points)
      : cloud(test::torus(points, 1)), set(make_site_set(cloud)), sites(set.perturbed) {
    mesh = make_tetrahedral_mesh(delaunay_tetrahedra(sites), sites);
    geometry = site_geometry(sites);
    evidence = facet_evidence(mesh, sites, geometry);
    for (const double width : ball_widths(mesh, sites, geometry.spacing, 1, 3))
      guess.push_back(std::isfinite(width) ? std::clamp((2 - width) * 3, -1.0, 1.0) : -1);
    belief = signed_field(mesh, evidence, geometry, guess);
    inside = cut();
    film = boundary_film();
  }

  Surface boundary_film() const {
    std::vector<char> labels = inside;
    LabelCosts costs{evidence.cost, std::vector<double>(mesh.size(), 0), {}};
    for (const double spacing : geometry.spacing) costs.off.push_back(5 * spacing * spacing);
    Labelling labelling(mesh, geometry, costs, labels);
    repair(labelling);
    reach(labelling);
    return surface_of_sites(tetrahedral_boundary(mesh, labels), sites);
  }

  /// The graph of sculpting: facets cost as the evidence says, and the belief of a tetrahedron weighs a tenth
  /// of its facets' area.
  std::vector<char> cut() const {
    CutGraph graph{mesh.mirror, {}, {}};
    graph.capacity.resize(mesh.size());
    graph.terminal.resize(mesh.size());
    std::vector<char> fallback(mesh.size(), 0);
    const double unit = 1e4 * static_cast<double>(sites.size());  // a facet has about 1 / sites of the area
    for (std::size_t t = 0; t < mesh.size(); ++t) {
      const bool outside = mesh.tets.infinite(static_cast<Index>(t));
      double area = 0;
      for (int k = 0; k < 4; ++k) {
        graph.capacity[t][k] = std::llround(unit * evidence.cost[t][k]);
        area += evidence.area[t][k];
      }
      graph.terminal[t] = outside ? -(std::int64_t(1) << 50) : std::llround(unit * 0.1 * area * belief[t]);
      fallback[t] = !outside && belief[t] > 0;
    }
    std::vector<char> inner = minimum_cut(graph, fallback);
    for (std::size_t t = 0; t < mesh.size(); ++t)
      if (mesh.tets.infinite(static_cast<Index>(t))) inner[t] = 0;
    return inner;
  }

  std::vector<Point> cloud;
  SiteSet set;
  const std::vector<Vec3>& sites;
  TetrahedralMesh mesh;
  SiteGeometry geometry;
  FacetEvidence evidence;
  std::vector<double> guess, belief;
  std::vector<char> inside;
  Surface film;
};

/// Built once for each number of points.
const Stages& stages(int points) {
  static std::map<int, std::unique_ptr<Stages>> built;
  std::unique_ptr<Stages>& found = built[points];
  if (!found) found = std::make_unique<Stages>(points);
  return *found;
}

template <typename Work>
void stage(const char* name, Work work) {
  benchmark::RegisterBenchmark(name,
                               [work](benchmark::State& state) {
                                 const Stages& s = stages(static_cast<int>(state.range(0)));
                                 for (auto _ : state) benchmark::DoNotOptimize(work(s));
                                 state.counters["points/s"] =
                                     benchmark::Counter(static_cast<double>(state.range(0)),
                                                        benchmark::Counter::kIsIterationInvariantRate);
                               })
      ->Arg(10000)
      ->Arg(100000)
      ->Unit(benchmark::kMillisecond)
      ->MeasureProcessCPUTime()
      ->UseRealTime();
}

void register_stages() {
  stage("site set", [](const Stages& s) { return make_site_set(s.cloud).size(); });
  stage("Delaunay tetrahedra", [](const Stages& s) { return delaunay_tetrahedra(s.sites).size(); });
  stage("the same by CGAL", [](const Stages& s) { return regular_tetrahedra(s.sites, {}).size(); });
  stage("site geometry", [](const Stages& s) { return site_geometry(s.sites).normal.size(); });
  stage("facet evidence",
        [](const Stages& s) { return facet_evidence(s.mesh, s.sites, s.geometry).cost.size(); });
  stage("carve widths",
        [](const Stages& s) { return ball_widths(s.mesh, s.sites, s.geometry.spacing, 1, 3).size(); });
  stage("signed field", [](const Stages& s) { return signed_field(s.mesh, s.evidence, s.geometry, s.guess).size(); });
  stage("minimum cut", [](const Stages& s) { return s.cut().size(); });
  stage("manifold labels and their boundary",
        [](const Stages& s) { return s.boundary_film().triangles.size(); });
  stage("flow map", [](const Stages& s) { return flow_map(s.mesh, s.sites).size(); });
  stage("film with dense virtual sites",
        [](const Stages& s) { return dense_film(s.mesh, s.sites, s.geometry.spacing, 2).size(); });
  stage("winding number of every tetrahedron", [](const Stages& s) {
    const WindingNumber winding(s.sites, film_dipoles(s.film, s.geometry.spacing));
    std::vector<double> value(s.mesh.size());
    parallel_each(value.size(), [&](std::size_t t) {
      Vec3 centre = Vec3::Zero();
      for (Index i : s.mesh.tets.corners[t])
        if (i != kNone) centre += s.sites[i] / 4;
      value[t] = winding(centre);
    });
    return value.size();
  });
  stage("12 nearest sites of every site", [](const Stages& s) {
    const PointTree tree(s.sites);
    std::vector<Index> farthest(s.sites.size());
    parallel_each(farthest.size(), [&](std::size_t i) { farthest[i] = tree.nearest(s.sites[i], 12).back(); });
    return farthest.size();
  });
  stage("nearest film point of every site", [](const Stages& s) {
    const SurfaceTree tree(s.film);
    std::vector<Index> triangle(s.sites.size());
    parallel_each(triangle.size(), [&](std::size_t i) { triangle[i] = tree.nearest(s.sites[i]).triangle; });
    return triangle.size();
  });
  stage("self-check: quality",
        [](const Stages& s) { return surface_quality(s.film, s.geometry).disagreement; });
  stage("self-check: orientation and manifold", [](const Stages& s) {
    Surface film = s.film;
    std::vector<Point> places;
    for (const Vec3& p : film.positions) places.push_back({p.x(), p.y(), p.z()});
    const SurfaceTopology topology(film.triangles, static_cast<Index>(film.positions.size()));
    orient_components(film, places, topology);
    return topology.check.ok();
  });
}

}  // namespace
}  // namespace filmsticking

int main(int argc, char** argv) {
  filmsticking::register_stages();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
