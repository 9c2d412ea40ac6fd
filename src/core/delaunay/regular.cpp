// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay/regular.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

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
using RegularCell =
    CGAL::Triangulation_cell_base_with_info_3<Index, Kernel, CGAL::Regular_triangulation_cell_base_3<Kernel>>;
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

// CGAL's order of points: growing random samples, so that too many tetrahedra show early.
std::vector<std::size_t> insertion_order(const std::vector<Kernel::Point_3>& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto place = CGAL::make_property_map(points);
  CGAL::spatial_sort(order.begin(), order.end(),
                     CGAL::Spatial_sort_traits_adapter_3<Kernel, decltype(place)>(place));
  return order;
}

template <class Triangulation, class At>
void insert_all(Triangulation& triangulation, const std::vector<Kernel::Point_3>& points, const At& at,
                const TriangulationLimits& limits) {
  constexpr std::size_t kOften = 256;
  const std::vector<std::size_t> order = insertion_order(points);
  typename Triangulation::Vertex_handle last;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto made = triangulation.insert(at(order[i]), last);
    if (made != typename Triangulation::Vertex_handle())  // not hidden
      last = made, last->info() = static_cast<Index>(order[i]);
    if (i % kOften != 0) continue;
    limits.cancel();
    if (static_cast<std::int64_t>(triangulation.tds().number_of_cells()) > limits.tetrahedra)
      throw TooManyTetrahedra{};
  }
}

template <class Triangulation>
Tetrahedra collect(const Triangulation& triangulation) {
  Tetrahedra tets;
  if (triangulation.dimension() < 3) return tets;
  std::vector<typename Triangulation::Cell_handle> cells;
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

}  // namespace

Tetrahedra regular_tetrahedra(const std::vector<Vec3>& sites, const std::vector<double>& weights,
                              const TriangulationLimits& limits) {
  std::vector<Kernel::Point_3> points;
  points.reserve(sites.size());
  for (const Vec3& p : sites) points.emplace_back(p.x(), p.y(), p.z());
  if (weights.empty()) {
    Delaunay triangulation;
    in_own_thread([&] {
      insert_all(
          triangulation, points, [&](std::size_t i) { return points[i]; }, limits);
    });
    return collect(triangulation);
  }
  Regular triangulation;
  const auto weighted = [&](std::size_t i) { return Regular::Weighted_point(points[i], weights[i]); };
  in_own_thread([&] { insert_all(triangulation, points, weighted, limits); });
  return collect(triangulation);
}

}  // namespace filmsticking
