// SPDX-License-Identifier: GPL-3.0-or-later
#include "point_distance.h"

#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Simple_cartesian.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>

namespace filmsticking::mesh_report {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Search = CGAL::Orthogonal_k_neighbor_search<CGAL::Search_traits_3<Kernel>>;

}  // namespace

struct PointDistance::Tree {
  Frame frame;  // of the points; they are kept in its unit box, where no square overflows
  Search::Tree search;

  Kernel::Point_3 place(const Vec3& p) const {
    const Vec3 unit = frame.to_unit(p);
    return {unit.x(), unit.y(), unit.z()};
  }
};

PointDistance::PointDistance(const std::vector<Vec3>& points) : tree_(new Tree{frame_of(points), {}}) {
  tree_->search.reserve(points.size());
  for (const Vec3& p : points) tree_->search.insert(tree_->place(p));
  tree_->search.build();  // before the first query: queries run in several threads
}

PointDistance::~PointDistance() = default;

std::vector<double> PointDistance::from(const std::vector<Vec3>& places) const {
  std::vector<double> distances(places.size());
  const double unit = tree_->frame.side > 0 ? tree_->frame.side : 1;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, places.size(), 256), [&](const auto& range) {
    for (std::size_t i = range.begin(); i != range.end(); ++i) {
      const Search search(tree_->search, tree_->place(places[i]), 1);
      distances[i] = std::sqrt(search.begin()->second) * unit;
    }
  });
  return distances;
}

}  // namespace filmsticking::mesh_report
