// SPDX-License-Identifier: GPL-3.0-or-later
#include "faults.h"
#include "method.h"
#include "peers.h"

namespace filmsticking::bench {

const std::vector<Method>& methods() {
  static const std::vector<Method> all = {
      {"ours", "FilmstickingPP with its defaults", true, run_ours},
      {"ours-paper", "FilmstickingPP with the paper's own pipeline", true, run_ours_paper},
      {"ours-rd", "FilmstickingPP as the paper's predecessor RD", true, run_ours_rd},
      {"paper-no-weights", "ours-paper without weights", true, run_paper_no_weights},
      {"paper-no-virtual", "ours-paper without virtual sites", true, run_paper_no_virtual},
      {"paper-no-smooth", "ours-paper without the smoothness rule", true, run_paper_no_smooth},
      {"paper-no-field", "ours-paper without the field and the last step", true, run_paper_no_field},
      {"ours-open", "FilmstickingPP with the faces left out that no points support", true, run_ours_open},
      {"ours-open-origin", "the same, with the origin as viewpoint, as in depth-frame", true,
       run_ours_open_origin},
      {"ours-sight", "FilmstickingPP with the sensor of each point", true, nullptr, run_ours_sight},
      {"ours-open-sight", "ours-open with the sensor of each point", true, nullptr, run_ours_open_sight},
      {"cgal-advancing-front", "CGAL Advancing_front_surface_reconstruction", true, run_cgal_advancing_front},
      {"cgal-alpha-wrap", "CGAL alpha_wrap_3: alpha 3 spacings, offset alpha / 100", true,
       run_cgal_alpha_wrap},
      {"cgal-scale-space", "CGAL Scale_space_surface_reconstruction_3: 4 steps, Advancing_front_mesher", true,
       run_cgal_scale_space},
      {"pcl-gp3", "PCL GreedyProjectionTriangulation with oriented normals", true, run_pcl_gp3},
      {"pcl-poisson", "PCL Poisson with oriented normals", true, run_pcl_poisson},
      {"pcl-poisson-sight", "PCL Poisson with PCL's normals, turned to the sensors", true, nullptr,
       run_pcl_poisson_sight},
      {"delaunay", "CGAL Delaunay_triangulation_3 of the points, one thread, no mesh", false, run_delaunay},
      {"fault-crash", "ends by a signal (for the tests)", true, run_fault_crash},
      {"fault-hang", "never ends (for the tests)", true, run_fault_hang},
      {"fault-throw", "throws (for the tests)", true, run_fault_throw},
      {"fault-memory", "takes memory without end (for the tests)", true, run_fault_memory},
  };
  return all;
}

}  // namespace filmsticking::bench
