// SPDX-License-Identifier: GPL-3.0-or-later
// mesh_view: what it shows, without a window; and the window as a user has it, judged by its screenshots.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "io/formats.h"
#include "io/io_error.h"
#include "mesh_view/contents.h"
#include "mesh_view/view_state.h"
#include "picture.h"
#include "support/model.h"

namespace filmsticking::test {
namespace {

namespace fs = std::filesystem;
using app::Action;
using app::Contents;
using app::Paint;
using app::Scope;
using app::ViewState;

TEST(ViewState, ArrowsStayWithinTheFilms) {
  const Scope scope{3, false, {Paint::Plain}};
  ViewState state;
  EXPECT_EQ(press("Left", scope, state), Action::None);
  EXPECT_EQ(press("Right", scope, state), Action::Draw);
  EXPECT_EQ(press("Right", scope, state), Action::Draw);
  EXPECT_EQ(state.film, 2u);
  EXPECT_EQ(press("Right", scope, state), Action::None);
  EXPECT_EQ(press("Home", scope, state), Action::Draw);
  EXPECT_EQ(state.film, 0u);
  press("End", scope, state);
  EXPECT_EQ(state.film, 2u);
  press("Left", scope, state);
  EXPECT_EQ(state.film, 1u);
  ViewState of_nothing;
  for (const char* key : {"Right", "Left", "End", "Home", "space"}) press(key, Scope{}, of_nothing);
  EXPECT_EQ(of_nothing.film, 0u);
  EXPECT_FALSE(of_nothing.playing);
}

TEST(ViewState, PlayingEndsAtTheLastFilmAndStartsOver) {
  const Scope scope{3, false, {Paint::Plain}};
  ViewState state;
  press("space", scope, state);
  ASSERT_TRUE(state.playing);
  play_on(scope, state);
  EXPECT_EQ(state.film, 1u);
  EXPECT_TRUE(state.playing);
  play_on(scope, state);
  EXPECT_EQ(state.film, 2u);
  EXPECT_FALSE(state.playing);
  press("space", scope, state);
  EXPECT_EQ(state.film, 0u);
  EXPECT_TRUE(state.playing);
  press("Right", scope, state);  // takes over
  EXPECT_FALSE(state.playing);
}

TEST(ViewState, EveryKeyOfTheHelpDoesSomething) {
  const Scope scope{3, true, {Paint::Plain, Paint::Faces, Paint::Points}};
  for (const char* key : {"Right", "Left", "Home", "End", "space", "m", "p", "b", "w", "c", "plus", "minus",
                          "r", "j", "h", "q"}) {
    ViewState state;
    state.film = 1;
    EXPECT_TRUE(app::is_key(key));
    EXPECT_NE(press(key, scope, state), Action::None) << key;
    EXPECT_NE(app::key_help().find(key), std::string::npos) << key;
  }
  ViewState state;
  EXPECT_EQ(press("x", scope, state), Action::None);
  EXPECT_EQ(press("", scope, state), Action::None);
  EXPECT_FALSE(app::is_key("right"));
  EXPECT_EQ(press("q", scope, state), Action::Quit);
  EXPECT_EQ(press("j", scope, state), Action::Screenshot);
  EXPECT_EQ(press("r", scope, state), Action::ResetView);
  press("b", scope, state);
  EXPECT_FALSE(state.holes);
  press("b", scope, state);
  EXPECT_TRUE(state.holes);
  for (int i = 0; i < 100; ++i) press("minus", scope, state);
  EXPECT_EQ(state.point_size, 1);
  for (int i = 0; i < 100; ++i) press("plus", scope, state);
  EXPECT_EQ(state.point_size, 20);
}

TEST(ViewState, ColoursGoAround) {
  const Scope scope{1, true, {Paint::Plain, Paint::Faces, Paint::Points}};
  ViewState state;
  for (const Paint paint : {Paint::Faces, Paint::Points, Paint::Plain, Paint::Faces}) {
    press("c", scope, state);
    EXPECT_EQ(state.paint, paint);
  }
}

/// A cube, and one that is higher by a half.
std::vector<scene::Step> two_cubes() {
  Model higher = cube(false, false);
  for (const int top : {2, 3, 6, 7}) higher.positions[top][1] = 1.5;
  return {{"low.ply", cube(false, false)}, {"high.ply", higher}};
}

TEST(Contents, OffersWhatThereIs) {
  const std::vector<Paint> plain{Paint::Plain};
  EXPECT_EQ(Contents(two_cubes(), {}, {}, 0).scope().paints, plain);
  EXPECT_EQ(Contents(two_cubes(), {}, {}, 0).scope().films, 2u);
  const pcl::PCLPointCloud2 cloud = io::make_cloud({{0, 2, 0}});
  EXPECT_EQ(Contents({}, cloud, {}, 0).scope().paints, plain);
  EXPECT_EQ(Contents(two_cubes(), cloud, cube(false, false), 0).scope().paints,
            (std::vector<Paint>{Paint::Plain, Paint::Faces, Paint::Points}));
  const pcl::PCLPointCloud2 coloured = io::make_cloud({{0, 2, 0}}, {{255, 0, 0}});
  EXPECT_EQ(Contents({}, coloured, {}, 0).scope().paints, (std::vector<Paint>{Paint::Plain, Paint::Colours}));
  EXPECT_THROW(Contents(two_cubes(), {}, Model{}, 0), io::IoError);
}

TEST(Contents, MeasuresTheFilmThatIsShown) {
  Contents contents(two_cubes(), io::make_cloud({{0.5, 2, 0.5}}), cube(false, false), 0);
  const auto most = [](const scene::Values& values) {
    return *std::max_element(values.begin(), values.end());
  };
  EXPECT_NEAR(most(contents.values(Paint::Faces, 0)), 0, 1e-12);
  EXPECT_NEAR(most(contents.values(Paint::Faces, 1)), 0.5, 1e-12);
  EXPECT_EQ(contents.values(Paint::Faces, 1).size(), 12u);
  EXPECT_NEAR(contents.values(Paint::Points, 0).at(0), 1, 1e-12);
  EXPECT_NEAR(contents.values(Paint::Points, 1).at(0), 0.5, 1e-12);
  EXPECT_NEAR(contents.scale(Paint::Faces), 0.5, 1e-12);  // of the last film, not of the first
  EXPECT_EQ(Contents(two_cubes(), {}, cube(false, false), 0.7).scale(Paint::Faces), 0.7);
}

TEST(Contents, SaysWhatIsShown) {
  const Contents contents(two_cubes(), io::make_cloud({{0.5, 2, 0.5}}), {}, 0);
  ViewState state;
  state.film = 1;
  state.paint = Paint::Points;
  const std::string line = app::status_line(contents, state);
  for (const char* part : {"high.ply", "2 of 2", "12 faces", "1 points", "points by distance"})
    EXPECT_NE(line.find(part), std::string::npos) << line;
}

class MeshView : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::string(XVFB_RUN).find("NOTFOUND") != std::string::npos)
      GTEST_SKIP() << "xvfb-run is not installed";
  }

  /// Presses the keys and expects the window to close by the last one. Returns the screenshots.
  std::vector<Picture> view(std::vector<std::string> arguments, const std::string& keys) {
    arguments.insert(arguments.end(),
                     {"--size", "400x300", "--screenshot", folder_ / "shot.png", "--press", keys});
    const Outcome outcome = run_on_display(XVFB_RUN, MESH_VIEW, arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    std::vector<Picture> shots;
    for (std::string name = folder_ / "shot.png"; fs::exists(name);
         name = folder_ / ("shot_" + std::to_string(shots.size() + 1) + ".png")) {
      EXPECT_NE(outcome.out.find("wrote " + name + "\n"), std::string::npos);
      shots.push_back(read_picture(name));
      EXPECT_EQ(shots.back().width, 400);
      EXPECT_EQ(shots.back().height, 300);
    }
    return shots;
  }

  ScratchFolder folder_;
};

TEST_F(MeshView, StepsThroughTheFilmOfARealScan) {
  ASSERT_EQ(run_program({PCD_TO_MESH, TEST_DATA "/bun0.pcd", folder_ / "bunny.ply", "--init", "sphere",
                         "--max-steps", "4", "--dump-steps", folder_ / "steps"})
                .status,
            0);
  const std::vector<Picture> shots =
      view({folder_ / "bunny.ply", "--steps", folder_ / "steps", "--points", TEST_DATA "/bun0.pcd"},
           "p j Right j End j Left Home j m p j q");
  ASSERT_EQ(shots.size(), 5u);
  std::vector<double> white;
  for (const Picture& shot : shots) white.push_back(count_pixels(shot).white);
  for (const double share : white) {
    EXPECT_GT(share, 0.3);
    EXPECT_LT(share, 0.98);
  }
  EXPECT_GT(white[1], white[0] + 0.05);  // from the sphere towards the bunny
  EXPECT_GT(white[2], white[0] + 0.05);
  EXPECT_NE(shots[2].pixels, shots[1].pixels);
  EXPECT_EQ(shots[3].pixels, shots[0].pixels);  // back again
  const Pixels points = count_pixels(shots[4]);
  EXPECT_GT(points.blue, 0.002);  // the cloud alone
  EXPECT_LT(points.blue, 0.1);
  EXPECT_EQ(count_pixels(shots[0]).blue, 0);
}

TEST_F(MeshView, PlaysToTheEndByItself) {
  fs::create_directory(folder_ / "steps");
  for (int i = 0; i < 3; ++i) {
    Model film = cube(false, false);
    for (Point& p : film.positions)
      for (double& x : p) x *= 3 - i;
    io::write_mesh(folder_ / ("steps/step_00" + std::to_string(i) + ".ply"), film);
  }
  const std::vector<Picture> shots =
      view({"--steps", folder_ / "steps"}, "j End j Home space wait wait wait j q");
  ASSERT_EQ(shots.size(), 3u);
  EXPECT_NE(shots[0].pixels, shots[1].pixels);
  EXPECT_EQ(shots[2].pixels, shots[1].pixels);
}

TEST_F(MeshView, HolesAreRedUntilTheyAreSwitchedOff) {
  io::write_mesh(folder_ / "open.ply", cube(true, false));
  // From below: neither the hole nor a back face is in sight, its edge is.
  const std::vector<Picture> shots = view({folder_ / "open.ply", "--view", "30,-20"}, "j b j w j b j h j q");
  ASSERT_EQ(shots.size(), 5u);
  const Pixels on = count_pixels(shots[0]), off = count_pixels(shots[1]);
  EXPECT_GT(on.red, 0.001);
  EXPECT_LT(on.red, 0.1);
  EXPECT_EQ(off.red, 0);
  EXPECT_GT(on.grey, 0.1);
  EXPECT_NE(shots[2].pixels, shots[1].pixels);  // edges of triangles
  EXPECT_GT(count_pixels(shots[3]).red, 0.001);
  EXPECT_LT(count_pixels(shots[4], 0, 0.3).white, count_pixels(shots[3], 0, 0.3).white - 0.01);  // the keys
}

TEST_F(MeshView, DistancesArePainted) {
  const std::vector<scene::Step> cubes = two_cubes();
  io::write_mesh(folder_ / "low.ply", cubes[0].film);
  io::write_mesh(folder_ / "high.ply", cubes[1].film);
  const std::vector<Picture> shots =
      view({folder_ / "high.ply", "--reference", folder_ / "low.ply", "--view", "0,90"}, "j c j c j q");
  ASSERT_EQ(shots.size(), 3u);
  EXPECT_EQ(count_pixels(shots[0]).blue, 0);
  EXPECT_GT(count_pixels(shots[1], 0, 0.7).blue, 0.2);   // the top is a half off
  EXPECT_GT(count_pixels(shots[1], 0.7, 1).blue, 0.01);  // the scale's bar
  EXPECT_EQ(shots[2].pixels, shots[0].pixels);
}

TEST_F(MeshView, ShowsARealCloudAlone) {
  const std::vector<Picture> shots = view({"--points", TEST_DATA "/milk.pcd"}, "j plus plus plus j q");
  ASSERT_EQ(shots.size(), 2u);
  EXPECT_GT(count_pixels(shots[0]).blue, 0.005);
  EXPECT_GT(count_pixels(shots[1]).blue, 1.1 * count_pixels(shots[0]).blue);
}

TEST_F(MeshView, AScreenshotThatCannotBeWrittenLeavesTheWindowOpen) {
  io::write_mesh(folder_ / "cube.ply", cube(false, false));
  const Outcome outcome = run_on_display(
      XVFB_RUN, MESH_VIEW,
      {folder_ / "cube.ply", "--screenshot", folder_ / "no/such.png", "--press", "j q", "--size", "200x200"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.err.rfind("mesh_view: ", 0), 0u) << outcome.err;
  EXPECT_NE(outcome.err.find("no/such.png"), std::string::npos);
  EXPECT_EQ(outcome.out, "");
}

TEST(MeshViewProgram, FailsInOneSentence) {
  const ScratchFolder folder;
  io::write_mesh(folder / "cube.ply", cube(false, false));
  const std::string mesh = folder / "cube.ply";
  const std::vector<std::pair<int, std::vector<std::string>>> cases = {
      {2, {}},
      {2, {mesh, mesh}},
      {2, {mesh, "--nonsense"}},
      {2, {mesh, "--press", "Right x"}},
      {2, {mesh, "--size", "10x10"}},
      {2, {mesh, "--view", "a,b"}},
      {2, {mesh, "--up", "x"}},
      {2, {mesh, "--range", "-1"}},
      {2, {mesh, "--screenshot", "shot.jpg"}},
      {2, {"--points", TEST_DATA "/bun0.pcd", "--reference", mesh}},
      {1, {folder / "missing.ply"}},
      {1, {TEST_DATA "/spot_10k.ply"}},  // points only
      {1, {mesh, "--points", folder / "missing.pcd"}},
      {1, {mesh, "--steps", folder.path().string()}},
      {1, {mesh, "--reference", TEST_DATA "/spot_10k.ply"}},
      {1, {mesh}},  // no display
  };
  for (const auto& [status, arguments] : cases) {
    std::vector<std::string> command = {"/usr/bin/env", "DISPLAY=:none", MESH_VIEW};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const Outcome outcome = run_program(command);
    EXPECT_EQ(outcome.status, status) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(outcome.err.rfind("mesh_view: ", 0), 0u) << outcome.err;
  }
  const Outcome help = run_program({MESH_VIEW, "--help"});
  EXPECT_EQ(help.status, 0);
  for (const char* option : {"--points", "--steps", "--reference", "--press", "space"})
    EXPECT_NE(help.out.find(option), std::string::npos);
}

}  // namespace
}  // namespace filmsticking::test
