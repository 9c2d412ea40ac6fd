// SPDX-License-Identifier: GPL-3.0-or-later
// The time of each stage of the core alone, on the results of the stages before it for points on a torus.
// "Time" is wall time, "CPU" the time of all threads together.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "delaunay/delaunay.h"
#include "delaunay/power_diagram.h"
#include "evidence/ball.h"
#include "evidence/facet_evidence.h"
#include "evidence/signed_field.h"
#include "film/film.h"
#include "film/restricted_power_diagram.h"
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

/// The results of every stage of the default pipeline, up to the film.
class House {
 public:
  explicit House(int points)
      : cloud(test::torus(points, 1)), set(make_site_set(cloud)), sites(set.perturbed) {
    mesh = make_tetrahedral_mesh(delaunay_tetrahedra(sites), sites);
    voronoi = voronoi_diagram(mesh.tets, sites);
    geometry = site_geometry(sites);
    evidence = facet_evidence(mesh, sites, geometry);
    for (const double width : ball_widths(mesh, sites, geometry.spacing, 1, 3))
      guess.push_back(std::isfinite(width) ? std::clamp((2 - width) * 3, -1.0, 1.0) : -1);
    belief = signed_field(mesh, evidence, guess);
    inside = cut();
    first_film = boundary_film();
    RepairCounts counts;
    film = film_step(first_film, voronoi, RingChoice::Smooth, counts);
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
  PowerDiagram voronoi;
  TetrahedralMesh mesh;
  SiteGeometry geometry;
  FacetEvidence evidence;
  std::vector<double> guess, belief;
  std::vector<char> inside;
  Surface first_film, film;
};

/// Built once for each number of points.
const House& house(int points) {
  static std::map<int, std::unique_ptr<House>> built;
  std::unique_ptr<House>& found = built[points];
  if (!found) found = std::make_unique<House>(points);
  return *found;
}

template <typename Work>
void room(const char* name, Work work) {
  benchmark::RegisterBenchmark(name,
                               [work](benchmark::State& state) {
                                 const House& h = house(static_cast<int>(state.range(0)));
                                 for (auto _ : state) benchmark::DoNotOptimize(work(h));
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

void register_rooms() {
  room("site set", [](const House& h) { return make_site_set(h.cloud).size(); });
  room("Delaunay triangulation", [](const House& h) { return DelaunayTriangulation(h.sites).dimension(); });
  room("Delaunay tetrahedra", [](const House& h) { return delaunay_tetrahedra(h.sites).size(); });
  room("Voronoi neighbours",
       [](const House& h) { return voronoi_diagram(h.mesh.tets, h.sites).neighbour.size(); });
  room("site geometry", [](const House& h) { return site_geometry(h.sites).normal.size(); });
  room("facet evidence",
       [](const House& h) { return facet_evidence(h.mesh, h.sites, h.geometry).cost.size(); });
  room("carve widths",
       [](const House& h) { return ball_widths(h.mesh, h.sites, h.geometry.spacing, 1, 3).size(); });
  room("signed field", [](const House& h) { return signed_field(h.mesh, h.evidence, h.guess).size(); });
  room("minimum cut", [](const House& h) { return h.cut().size(); });
  room("manifold labels and their boundary",
       [](const House& h) { return h.boundary_film().triangles.size(); });
  room("restricted power diagram", [](const House& h) {
    const auto vertices = static_cast<Index>(h.first_film.positions.size());
    return restrict_power_diagram(h.first_film, half_edge_twins(h.first_film.triangles, vertices), h.voronoi)
        .cell.size();
  });
  room("film step", [](const House& h) {
    RepairCounts counts;
    return film_step(h.first_film, h.voronoi, RingChoice::Smooth, counts).triangles.size();
  });
  room("winding number of every tetrahedron", [](const House& h) {
    const WindingNumber winding(h.sites, film_dipoles(h.film, h.sites.size()));
    std::vector<double> value(h.mesh.size());
    parallel_each(value.size(), [&](std::size_t t) {
      Vec3 centre = Vec3::Zero();
      for (Index i : h.mesh.tets.corners[t])
        if (i != kNone) centre += h.sites[i] / 4;
      value[t] = winding(centre);
    });
    return value.size();
  });
  room("12 nearest sites of every site", [](const House& h) {
    const PointTree tree(h.sites);
    std::vector<Index> farthest(h.sites.size());
    parallel_each(farthest.size(), [&](std::size_t i) { farthest[i] = tree.nearest(h.sites[i], 12).back(); });
    return farthest.size();
  });
  room("nearest film point of every site", [](const House& h) {
    const SurfaceTree tree(h.film);
    std::vector<Index> triangle(h.sites.size());
    parallel_each(triangle.size(), [&](std::size_t i) { triangle[i] = tree.nearest(h.sites[i]).triangle; });
    return triangle.size();
  });
  room("self-check: quality",
       [](const House& h) { return surface_quality(h.film, h.geometry).disagreement; });
  room("self-check: orientation and manifold", [](const House& h) {
    Surface film = h.film;
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
  filmsticking::register_rooms();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
