// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/report.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <limits>
#include <string>

#include "support/shapes.h"

namespace filmsticking::mesh_report {
namespace {

using test::joined;
using test::torus;

TEST(MeshReport, IsTheSameWithAnyNumberOfThreads) {
  const Surface mesh = make_surface(joined(torus(), torus({0.3, 0.2, 0.1}))), truth = make_surface(torus());
  const auto all = [&] {
    Report r = report_on(mesh);
    r.cloud = cloud_fit(mesh, torus({0, 0, 0.01}).positions);
    r.truth = truth_fit(mesh, r.topology, truth, 5000);
    return to_json(r);
  };
  std::string alone;
  {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    alone = all();
  }
  const tbb::global_control four(tbb::global_control::max_allowed_parallelism, 4);
  EXPECT_EQ(all(), alone);
}

TEST(MeshReport, JsonHasNoInfinity) {
  Report r;
  r.area = std::numeric_limits<double>::infinity();
  EXPECT_NE(to_json(r).find("\"area\": null"), std::string::npos);
}

}  // namespace
}  // namespace filmsticking::mesh_report
