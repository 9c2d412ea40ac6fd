// SPDX-License-Identifier: GPL-3.0-or-later
// The methods, one a source file: each is a heavy template of its own.
#pragma once

#include <vector>

#include "method.h"

namespace filmsticking::bench {

Outcome run_ours(const std::vector<Point>& points, int threads);
Outcome run_ours_paper(const std::vector<Point>& points, int threads);
Outcome run_ours_rd(const std::vector<Point>& points, int threads);
Outcome run_paper_no_weights(const std::vector<Point>& points, int threads);
Outcome run_paper_no_virtual(const std::vector<Point>& points, int threads);
Outcome run_paper_no_smooth(const std::vector<Point>& points, int threads);
Outcome run_paper_no_field(const std::vector<Point>& points, int threads);
Outcome run_ours_open(const std::vector<Point>& points, int threads);
Outcome run_ours_open_origin(const std::vector<Point>& points, int threads);
Outcome run_ours_sight(const SeenCloud& cloud, int threads);
Outcome run_ours_open_sight(const SeenCloud& cloud, int threads);
Outcome run_delaunay(const std::vector<Point>& points, int threads);
Outcome run_cgal_advancing_front(const std::vector<Point>& points, int threads);
Outcome run_cgal_alpha_wrap(const std::vector<Point>& points, int threads);
Outcome run_cgal_scale_space(const std::vector<Point>& points, int threads);
Outcome run_pcl_gp3(const std::vector<Point>& points, int threads);
Outcome run_pcl_poisson(const std::vector<Point>& points, int threads);
Outcome run_pcl_poisson_sight(const SeenCloud& cloud, int threads);
Outcome run_open3d_ball_pivoting(const std::vector<Point>& points, int threads);
Outcome run_open3d_poisson(const std::vector<Point>& points, int threads);

}  // namespace filmsticking::bench
