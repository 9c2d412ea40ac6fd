// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay/power_diagram.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <exception>
#include <numeric>
#include <system_error>
#include <thread>
#include <utility>

#include "geometry/parallel.h"

namespace filmsticking {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_3<Index, Kernel>;
using Cell = CGAL::Triangulation_cell_base_with_info_3<Index, Kernel>;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Vertex, Cell>>;

using RegularVertex =
    CGAL::Triangulation_vertex_base_with_info_3<Index, Kernel,
                                                CGAL::Regular_triangulation_vertex_base_3<Kernel>>;
using RegularCell = CGAL::Regular_triangulation_cell_base_3<Kernel>;
using Regular =
    CGAL::Regular_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<RegularVertex, RegularCell>>;

// Runs `work` in a thread of its own. CGAL keeps scratch per thread; an allocation that fails midway leaves
// it broken for that thread's next triangulations.
template <class Work>
void in_own_thread(const Work& work) {
  std::exception_ptr thrown;
  std::thread thread;
  try {
    thread = std::thread([&] {
      try {
        work();
      } catch (...) {
        thrown = std::current_exception();
      }
    });
  } catch (const std::system_error&) {  // no thread is left
    return work();
  }
  thread.join();
  if (thrown) std::rethrow_exception(thrown);
}

Kernel::Point_3 cgal_point(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

// Sorted, so that nothing depends on the triangulation's own order.
template <class Triangulation>
void collect_neighbours(const Triangulation& triangulation, PowerDiagram& diagram) {
  std::vector<std::pair<Index, Index>> edges;
  edges.reserve(8 * triangulation.number_of_vertices());
  for (auto e = triangulation.finite_edges_begin(); e != triangulation.finite_edges_end(); ++e)
    edges.emplace_back(e->first->vertex(e->second)->info(), e->first->vertex(e->third)->info());
  diagram.offset.assign(diagram.position.size() + 1, 0);
  for (const auto& [a, b] : edges) ++diagram.offset[a + 1], ++diagram.offset[b + 1];
  for (std::size_t i = 1; i < diagram.offset.size(); ++i) diagram.offset[i] += diagram.offset[i - 1];
  diagram.neighbour.resize(2 * edges.size());
  std::vector<Index> fill(diagram.offset.begin(), diagram.offset.end() - 1);
  for (const auto& [a, b] : edges) diagram.neighbour[fill[a]++] = b, diagram.neighbour[fill[b]++] = a;
  for (std::size_t i = 0; i + 1 < diagram.offset.size(); ++i) {
    std::sort(diagram.neighbour.begin() + diagram.offset[i],
              diagram.neighbour.begin() + diagram.offset[i + 1]);
    if (diagram.any_site == kNone && diagram.has_cell(static_cast<Index>(i)))
      diagram.any_site = static_cast<Index>(i);
  }
}

}  // namespace

Index PowerDiagram::owner(const Vec3& x, Index hint) const {
  Index best = hint != kNone && has_cell(hint) ? hint : any_site;
  if (best == kNone) return kNone;
  double least = power(best, x);
  // In a Delaunay or regular triangulation a site without a better neighbour is the best. Ends: the power
  // falls with every move.
  for (bool moved = true; moved;) {
    moved = false;
    const Index from = best;
    for (Index k = offset[from]; k < offset[from + 1]; ++k) {
      const double p = power(neighbour[k], x);
      if (p < least) least = p, best = neighbour[k], moved = true;
    }
  }
  return best;
}

struct DelaunayTriangulation::Impl {
  std::vector<Vec3> sites;
  Delaunay triangulation;
  std::vector<Delaunay::Vertex_handle> vertex;
};

DelaunayTriangulation::DelaunayTriangulation(std::vector<Vec3> sites, const TriangulationLimits& limits)
    : impl_(new Impl) {
  impl_->sites = std::move(sites);
  std::vector<Kernel::Point_3> points;
  points.reserve(impl_->sites.size());
  for (const Vec3& p : impl_->sites) points.push_back(cgal_point(p));
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto place = CGAL::make_property_map(points);
  CGAL::spatial_sort(order.begin(), order.end(),
                     CGAL::Spatial_sort_traits_adapter_3<Kernel, decltype(place)>(place));
  // CGAL's order is one of growing random samples, so that too many tetrahedra show early.
  constexpr std::size_t kOften = 256;
  Delaunay& triangulation = impl_->triangulation;
  const auto insert_all = [&] {
    Delaunay::Vertex_handle last;
    for (std::size_t i = 0; i < order.size(); ++i) {
      last = triangulation.insert(points[order[i]], last);
      last->info() = static_cast<Index>(order[i]);
      if (i % kOften != 0) continue;
      limits.cancel();
      if (static_cast<std::int64_t>(triangulation.tds().number_of_cells()) > limits.tetrahedra)
        throw TooManyTetrahedra{};
    }
  };
  in_own_thread(insert_all);
  impl_->vertex.resize(impl_->sites.size());
  for (auto v : impl_->triangulation.finite_vertex_handles()) impl_->vertex[v->info()] = v;
}

DelaunayTriangulation::~DelaunayTriangulation() = default;

int DelaunayTriangulation::dimension() const { return impl_->triangulation.dimension(); }

void DelaunayTriangulation::remove(Index site) {
  auto& v = impl_->vertex[site];
  if (v == nullptr) return;
  impl_->triangulation.remove(v);
  v = nullptr;
}

PowerDiagram DelaunayTriangulation::voronoi() const {
  PowerDiagram diagram;
  diagram.position = impl_->sites;
  collect_neighbours(impl_->triangulation, diagram);
  return diagram;
}

Tetrahedra DelaunayTriangulation::tetrahedra() const {
  Tetrahedra tets;
  const auto& triangulation = impl_->triangulation;
  std::vector<Delaunay::Cell_handle> cells;
  cells.reserve(triangulation.number_of_cells());
  for (auto c : triangulation.all_cell_handles()) {
    c->info() = static_cast<Index>(cells.size());
    cells.push_back(c);
  }
  tets.corners.resize(cells.size());
  tets.neighbours.resize(cells.size());
  parallel_each(cells.size(), [&](std::size_t t) {
    for (int k = 0; k < 4; ++k) {
      const auto v = cells[t]->vertex(k);
      tets.corners[t][k] = triangulation.is_infinite(v) ? kNone : v->info();
      tets.neighbours[t][k] = cells[t]->neighbor(k)->info();
    }
  });
  return tets;
}

PowerDiagram weighted_power_diagram(const std::vector<Vec3>& sites, const std::vector<double>& weights,
                                    const std::vector<char>& present) {
  std::vector<std::pair<Regular::Weighted_point, Index>> points;
  points.reserve(sites.size());
  for (std::size_t i = 0; i < sites.size(); ++i)
    if (present[i])
      points.emplace_back(Regular::Weighted_point(cgal_point(sites[i]), weights[i]), static_cast<Index>(i));
  Regular triangulation;
  in_own_thread([&] { triangulation.insert(points.begin(), points.end()); });
  PowerDiagram diagram;
  diagram.position = sites;
  diagram.weight = weights;
  collect_neighbours(triangulation, diagram);
  return diagram;
}

}  // namespace filmsticking
