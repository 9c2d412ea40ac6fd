// SPDX-License-Identifier: GPL-3.0-or-later
// The page of --html, as headless Chromium shows it: judged by pixels, and by what its script put into the
// document.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "io/formats.h"
#include "picture.h"
#include "support/model.h"
#include "support/run_program.h"
#include "support/scratch_folder.h"

namespace filmsticking::test {
namespace {

constexpr int kWidth = 800, kHeight = 500;
constexpr double kSide = 330. / kWidth;  // the share of the page beside the view

void run(const std::vector<std::string>& command) {
  const Outcome outcome = run_program(command);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
}

std::string read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), {});
}

/// The shares of the view by what they show. Light darkens colours, so that hues decide.
struct Shown {
  double background = 0, front = 0, back = 0, rim = 0, surplus = 0, meeting = 0, far = 0;
};

Shown shown(const std::string& picture_file) {
  const Picture picture = read_picture(picture_file);
  EXPECT_EQ(picture.width, kWidth);
  Shown shares;
  const int width = static_cast<int>(kWidth * (1 - kSide));
  const double one = 1. / width / picture.height;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto [r, g, b] = picture.pixels[static_cast<std::size_t>(y) * picture.width + x];
      if (std::min({r, g, b}) > 250) {
        shares.background += one;
      } else if (r > 150 && g < 60 && b < 60) {
        shares.rim += one;
      } else if (b > g + 60 && r > g + 60) {
        shares.surplus += one;
      } else if (r > g + 30 && g > b + 60) {
        shares.meeting += one;
      } else if (r > 1.3 * g && r > 1.3 * b) {
        shares.back += one;
      } else if (b > r + 60) {
        shares.far += one;
      } else {
        shares.front += one;
      }
    }
  return shares;
}

class Page : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::string(CHROMIUM).empty()) GTEST_SKIP() << "chromium is not installed: apt-get install chromium";
  }

  std::string write(const std::string& name, const Model& mesh) {
    io::write_mesh(folder / name, mesh);
    return folder / name;
  }

  /// The page of a mesh.
  void report(const std::string& mesh, std::vector<std::string> more = {}) {
    more.insert(more.begin(), {MESH_REPORT, mesh, "--html", folder / "page.html"});
    run(more);
  }

  /// What Chromium prints of the page, with what `shows` stands behind a # in its address.
  std::string browse(const std::string& shows, std::vector<std::string> options) {
    options.insert(
        options.begin(),
        {CHROMIUM, "--headless", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
         "--hide-scrollbars", "--force-prefers-reduced-motion", "--force-device-scale-factor=1",
         "--user-data-dir=" + folder / "browser", "--virtual-time-budget=4000",
         "--window-size=" + std::to_string(kWidth) + "," + std::to_string(kHeight)});
    options.emplace_back("file://" + folder / "page.html" + (shows.empty() ? "" : "#" + shows));
    const Outcome outcome = run_program(options);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.out;
  }

  Shown picture(const std::string& shows) {
    browse(shows, {"--screenshot=" + folder / "page.png"});
    return shown(folder / "page.png");
  }

  /// Adds a script that runs when the page is drawn.
  void act(const std::string& script) {
    std::ofstream(folder / "page.html", std::ios::app)
        << "<script>setTimeout(() => {" << script << "}, 300)</script>";
  }

  std::string document(const std::string& shows = "") { return browse(shows, {"--dump-dom"}); }

  const ScratchFolder folder;
};

/// Two cubes that share the square 5 7 at their sides, or pass through each other.
Model two_cubes(double shift) {
  Model model = cube(false, false);
  const Model other = cube(false, false);
  const int n = static_cast<int>(model.positions.size());
  for (const Point& p : other.positions) model.positions.push_back({p[0] + shift, p[1] + shift, p[2]});
  for (const Triangle& t : other.triangles) model.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  return model;
}

/// A ball of a grid; `hole` leaves out a few faces around (1, 0, 0).
Model ball(bool hole, int rows = 24) {
  Model model;
  const int columns = 2 * rows;
  for (int i = 0; i <= rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const double theta = M_PI * i / rows, phi = M_PI * j / rows;
      model.positions.push_back(
          {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)});
    }
  const auto add = [&](int a, int b, int c) {
    Point middle{};
    for (const int v : {a, b, c})
      for (int k = 0; k < 3; ++k) middle[k] += model.positions[v][k] / 3;
    if (!hole || middle[0] < 0.95) model.triangles.push_back({a, b, c});
  };
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const int a = i * columns + j, b = i * columns + (j + 1) % columns;
      if (i + 1 < rows) add(a, a + columns, b + columns);
      if (i > 0) add(a, b + columns, b);
    }
  for (int j = 0; j < columns; ++j) {  // the poles, where a row is one place
    model.positions[j] = model.positions[0];
    model.positions[rows * columns + j] = model.positions[rows * columns];
  }
  return model;
}

TEST_F(Page, OfAClosedMeshHasNoMarks) {
  report(write("ball.ply", ball(false)));
  const Shown seen = picture("");
  EXPECT_GT(seen.background, 0.3);
  EXPECT_GT(seen.front, 0.2);
  EXPECT_EQ(seen.rim + seen.back + seen.surplus + seen.meeting + seen.far, 0);
}

TEST_F(Page, ShowsBacksAndRims) {
  report(write("open.ply", cube(true, false)));
  const Shown inside = picture("view=0,90");  // the side that is missing is the upper one
  EXPECT_GT(inside.back, 0.1);
  EXPECT_GT(inside.rim, 0.005);
  const Shown unmarked = picture("view=0,90&hide=backs,boundary");
  EXPECT_EQ(unmarked.back + unmarked.rim, 0);
  EXPECT_GT(unmarked.front, 0.1);
}

TEST_F(Page, ShowsFacesThatMeetAndEdgesOfMoreFaces) {
  report(write("through.ply", two_cubes(0.5)));
  EXPECT_GT(picture("").meeting, 0.05);
  EXPECT_EQ(picture("hide=meeting").meeting, 0);
  report(write("side_by_side.ply", two_cubes(1)));  // one edge has four faces
  EXPECT_GT(picture("view=45,0").surplus, 0.0005);
}

TEST_F(Page, ShowsDistancesToTruthAndPointsAsColoursAndHistogram) {
  const std::string mesh = write("near.ply", ball(false)), truth = write("truth.ply", ball(false));
  Model half = ball(false);
  for (Point& p : half.positions) p[0] += p[0] > 0.5 ? 0.3 : 0;
  report(write("far.ply", half), {"--truth", truth, "--points", truth});
  // From +x the faces are far from the truth and from the points; from the other side they are not.
  for (const std::string colours : {"colours=truth_distances", "colours=cloud_distances"}) {
    EXPECT_GT(picture(colours + "&view=90,0").far, 0.1) << colours;
    EXPECT_LT(picture(colours + "&view=270,0").far, 0.01) << colours;
  }
  EXPECT_GT(picture("colours=point_distances&view=90,0").far, 0.001);
  EXPECT_NE(document("colours=truth_distances").find("<rect"), std::string::npos);
}

TEST_F(Page, LooksAtAHoleFromOutsideAlsoWhereTheMeshIsInsideOut) {
  Model mesh = ball(true);
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  report(write("inside_out.ply", mesh));
  // Outside shows backs around the hole, and through it the fronts of the far side.
  const Shown there = picture("hole=1");
  EXPECT_GT(there.back, 0.2);
  EXPECT_LT(there.front, 0.2);
  EXPECT_GT(there.front, 0.02);
}

TEST_F(Page, FliesToAHoleThatIsClicked) {
  report(write("hole.ply", ball(true)));
  EXPECT_EQ(picture("view=270,0").rim, 0);
  act("document.querySelectorAll('#holes tr')[1].click()");
  const Shown there = picture("view=270,0");
  EXPECT_GT(there.rim, 0.002);
  EXPECT_GT(there.back, 0.02);  // through the hole
  EXPECT_NE(document().find("Holes and rims: 1<"), std::string::npos);
}

TEST_F(Page, TurnsUnderTheMouse) {
  report(write("open.ply", cube(true, false)));
  EXPECT_EQ(picture("view=0,-10&hide=boundary").back, 0);
  act("const canvas = document.querySelector('canvas');"
      "const at = (type, y) => new MouseEvent(type, {clientX: 200, clientY: y, button: 0, bubbles: true});"
      "canvas.dispatchEvent(at('mousedown', 150));"
      "document.dispatchEvent(at('mousemove', 250));"
      "setTimeout(() => document.dispatchEvent(at('mouseup', 250)), 100);");
  EXPECT_GT(picture("view=0,-10&hide=boundary").back, 0.02);  // what was above is in front
}

TEST_F(Page, ShowsAMillionTriangles) {
  const std::string mesh = write("million.ply", ball(false, 501));
  report(mesh);
  EXPECT_GT(picture("").front, 0.2);
  EXPECT_NE(read(folder / "page.html").find("<td>1002000</td>"), std::string::npos);
}

TEST_F(Page, OfPcdToMeshHasItsPoints) {
  run({PCD_TO_MESH, TEST_DATA "/bun0.pcd", folder / "bun.ply", "--open", "--html", folder / "page.html"});
  const Shown seen = picture("show=points");
  EXPECT_GT(seen.front, 0.2);
  EXPECT_GT(seen.far, 0.001);
}

TEST_F(Page, WithoutWebGLStillHasTheReport) {
  report(write("ball.ply", ball(false)));
  const std::string page = browse("", {"--dump-dom", "--disable-3d-apis"});
  EXPECT_NE(page.find("has no WebGL"), std::string::npos);
  EXPECT_NE(page.find("self-intersections"), std::string::npos);
}

// ---- Without a browser ----

TEST(PageFile, OfNothingOrHostileNamesIsWhole) {
  const ScratchFolder folder;
  std::ofstream(folder / "none.ply") << "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\n"
                                        "property float y\nproperty float z\nend_header\n";
  run({MESH_REPORT, folder / "none.ply", "--html", folder / "none.html"});
  EXPECT_NE(read(folder / "none.html").find("</html>"), std::string::npos);
  Model huge = cube(true, false);
  for (Point& p : huge.positions) p[0] *= 1e99;
  io::write_mesh(folder / "<script>.obj", huge);
  run({MESH_REPORT, folder / "<script>.obj", "--html", folder / "huge.html"});
  EXPECT_NE(read(folder / "huge.html").find("<h1>&lt;script&gt;.obj</h1>"), std::string::npos);
}

TEST(PageFile, IsTheSameEachTimeAndNamesNoServer) {
  const ScratchFolder folder;
  io::write_mesh(folder / "cube.ply", cube(true, false));
  for (const char* page : {"one.html", "two.html"})
    run({MESH_REPORT, folder / "cube.ply", "--points", folder / "cube.ply", "--html", folder / page});
  const std::string text = read(folder / "one.html");
  EXPECT_EQ(text, read(folder / "two.html"));
  EXPECT_NE(text.find("default-src 'none'"), std::string::npos);
  for (const char* link : {"src=\"http", "href=\"http"}) EXPECT_EQ(text.find(link), std::string::npos);
  EXPECT_NE(text.find("Permission is hereby granted"), std::string::npos);  // the licence of three.js
}

TEST(PageFile, FailsInOneSentence) {
  const ScratchFolder folder;
  io::write_mesh(folder / "cube.ply", cube(true, false));
  const Outcome outcome =
      run_program({MESH_REPORT, folder / "cube.ply", "--html", folder / "no_folder/page.html"});
  EXPECT_EQ(run_program({MESH_REPORT, folder / "cube.ply", "--html", folder / "cube.ply"}).status, 2);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("page.html"), std::string::npos) << outcome.err;
  const Outcome two = run_program({PCD_TO_MESH, TEST_DATA "/bun0.pcd", TEST_DATA "/bun4.pcd",
                                   folder.path().string(), "--html", folder / "page.html"});
  EXPECT_EQ(two.status, 2);
  EXPECT_NE(two.err.find("--html takes one input only"), std::string::npos) << two.err;
}

}  // namespace
}  // namespace filmsticking::test
