// SPDX-License-Identifier: GPL-3.0-or-later
// pcd_to_mesh as a user runs it.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "io/files.h"
#include "support/model.h"
#include "support/run_program.h"
#include "support/scratch_folder.h"
#include "support/surface_check.h"

namespace filmsticking::test {

using Json = nlohmann::json;

inline const std::string kBunny = TEST_DATA "/bun0.pcd", kSpot = TEST_DATA "/spot_10k.ply";

inline Outcome pcd_to_mesh(std::vector<std::string> arguments,
                           const std::function<void(pid_t)>& while_running = nullptr) {
  arguments.insert(arguments.begin(), PCD_TO_MESH);
  return run_program(arguments, while_running);
}

inline Json read_json(const std::string& path) { return Json::parse(io::read_file(path)); }

inline void expect_surface_through(const Model& mesh, const Model& cloud) {
  const Mesh surface{mesh.positions, mesh.triangles};
  EXPECT_EQ(surface_fault(surface), "");
  EXPECT_GT(signed_volume(surface), 0);
  const std::set<Point> points(cloud.positions.begin(), cloud.positions.end());
  for (const Point& p : mesh.positions) ASSERT_TRUE(points.count(p));
}

/// One sentence on stderr, a status that is not 0, and nothing in the folder that was not there.
inline void expect_failure(const std::vector<std::string>& arguments, const ScratchFolder& folder,
                           int status) {
  const std::size_t before = folder.count();
  const Outcome outcome = pcd_to_mesh(arguments);
  EXPECT_EQ(outcome.status, status) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_EQ(outcome.err.rfind("pcd_to_mesh: ", 0), 0u) << outcome.err;
  EXPECT_GT(outcome.err.size(), 20u);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(folder.count(), before) << outcome.err;
}

}  // namespace filmsticking::test
