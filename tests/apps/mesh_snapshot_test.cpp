// SPDX-License-Identifier: GPL-3.0-or-later
// mesh_snapshot as a user runs it; what it drew is judged by its pixels.
#include <gif_lib.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "io/formats.h"
#include "picture.h"
#include "support/model.h"
#include "support/run_program.h"
#include "support/scratch_folder.h"

namespace filmsticking::test {
namespace {

namespace fs = std::filesystem;

Outcome mesh_snapshot(const std::vector<std::string>& arguments) {
  return run_on_display(XVFB_RUN, MESH_SNAPSHOT, arguments);
}

class MeshSnapshot : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::string(XVFB_RUN).find("NOTFOUND") != std::string::npos)
      GTEST_SKIP() << "xvfb-run is not installed";
  }
  ScratchFolder folder_;
};

TEST_F(MeshSnapshot, DrawsAClosedMeshWithoutRed) {
  io::write_mesh(folder_ / "cube.ply", cube(false, false));
  const Outcome outcome = mesh_snapshot({folder_ / "cube.ply", "-o", folder_ / "cube.png"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Pixels pixels = read_pixels(folder_ / "cube.png");
  EXPECT_EQ(pixels.width, 700);
  EXPECT_EQ(pixels.height, 700);
  EXPECT_GT(pixels.grey, 0.4);
  EXPECT_GT(pixels.white, 0.2);
  EXPECT_EQ(pixels.red, 0);
  EXPECT_EQ(pixels.violet, 0);
  EXPECT_EQ(folder_.count(), 2u);
}

TEST_F(MeshSnapshot, InsideOutIsRedAndHolesHaveRedEdges) {
  io::write_mesh(folder_ / "turned.ply", cube(false, true));
  io::write_mesh(folder_ / "open.obj", cube(true, false));
  const Outcome outcome = mesh_snapshot({folder_ / "turned.ply", folder_ / "open.obj", "-o",
                                         folder_ / "two.png", "--size", "600x300", "--view", "30,-20"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Pixels turned = read_pixels(folder_ / "two.png", 0, 0.5),
               open = read_pixels(folder_ / "two.png", 0.5, 1);
  EXPECT_EQ(turned.width, 600);
  EXPECT_EQ(turned.height, 300);
  EXPECT_GT(turned.red, 0.4);
  EXPECT_LT(turned.grey, 0.02);
  EXPECT_GT(open.red, 0.001);  // lines, seen from below
  EXPECT_LT(open.red, 0.1);
  EXPECT_GT(open.grey, 0.3);
}

TEST_F(MeshSnapshot, BacksCanBeGreySoThatRedIsForHoles) {
  io::write_mesh(folder_ / "turned.ply", cube(false, true));
  ASSERT_EQ(mesh_snapshot({folder_ / "turned.ply", "-o", folder_ / "turned.png", "--grey-backs"}).status, 0);
  const Pixels pixels = read_pixels(folder_ / "turned.png");
  EXPECT_EQ(pixels.red, 0);
  EXPECT_GT(pixels.grey, 0.4);
}

TEST_F(MeshSnapshot, TheInsideShowsThroughAHole) {
  io::write_mesh(folder_ / "open.ply", cube(true, false));
  ASSERT_EQ(mesh_snapshot({folder_ / "open.ply", "-o", folder_ / "open.png", "--view=30,60"}).status, 0);
  EXPECT_GT(read_pixels(folder_ / "open.png").red, 0.1);
}

TEST_F(MeshSnapshot, EdgesWithThreeFacesAreViolet) {
  Model model = cube(false, false);
  model.positions.push_back({2, 2, 2});
  model.triangles.push_back({6, 7, 8});
  io::write_mesh(folder_ / "fin.ply", model);
  ASSERT_EQ(mesh_snapshot({folder_ / "fin.ply", "-o", folder_ / "fin.png"}).status, 0);
  EXPECT_GT(read_pixels(folder_ / "fin.png").violet, 0.0005);
}

TEST_F(MeshSnapshot, EveryFormatGivesTheSamePicture) {
  std::vector<std::string> arguments;
  for (const char* name : {"cube.ply", "cube.obj", "cube.stl", "cube.vtk"}) {
    io::write_mesh(folder_ / name, cube(false, false));
    arguments.push_back(folder_ / name);
  }
  for (const char* word : {"--columns", "4", "--size", "800x200", "-o"}) arguments.push_back(word);
  arguments.push_back(folder_ / "all.png");
  const Outcome outcome = mesh_snapshot(arguments);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const double first = read_pixels(folder_ / "all.png", 0, 0.25).grey;
  EXPECT_GT(first, 0.4);
  for (const double begin : {0.25, 0.5, 0.75})
    EXPECT_NEAR(read_pixels(folder_ / "all.png", begin, begin + 0.25).grey, first, 0.002);
}

TEST_F(MeshSnapshot, PointsEdgesLabelsAndRowsAreDrawn) {
  io::write_mesh(folder_ / "cube.ply", cube(false, false));
  const std::string mesh = folder_ / "cube.ply";
  const Outcome outcome =
      mesh_snapshot({mesh, mesh, mesh, "--points", TEST_DATA "/spot_10k.ply", "--edges", "--labels",
                     "--columns", "2", "--up", "z", "-o", folder_ / "all.png"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Pixels pixels = read_pixels(folder_ / "all.png");
  EXPECT_EQ(pixels.width, 1400);
  EXPECT_EQ(pixels.height, 1400);
  EXPECT_GT(pixels.blue, 0.005);
}

TEST_F(MeshSnapshot, FitSaysWhatSharesAScale) {
  io::write_mesh(folder_ / "small.ply", cube(false, false));
  Model large = cube(false, false);
  for (Point& p : large.positions) p = {10 * p[0], 10 * p[1], 10 * p[2]};
  io::write_mesh(folder_ / "large.ply", large);
  const auto grey_of_small = [&](const std::string& fit, const std::string& columns) {
    const Outcome outcome =
        mesh_snapshot({folder_ / "small.ply", folder_ / "large.ply", "--fit", fit, "--columns", columns, "-o",
                       folder_ / "two.png", "--size", "400x400"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return read_pixels(folder_ / "two.png", 0, columns == "2" ? 0.5 : 1).grey;
  };
  EXPECT_LT(grey_of_small("all", "2"), 0.02);
  EXPECT_LT(grey_of_small("row", "2"), 0.02);
  EXPECT_GT(grey_of_small("each", "2"), 0.2);
  // Below each other, a row each: half of the picture is the small cube's.
  const double alone = grey_of_small("row", "1");
  EXPECT_GT(alone, 1.5 * grey_of_small("all", "1"));
}

TEST_F(MeshSnapshot, ADashLeavesItsPlaceEmptyAndLabelsAreOwnTexts) {
  io::write_mesh(folder_ / "cube.ply", cube(false, false));
  const std::vector<std::string> panels = {folder_ / "cube.ply", "-",      "-o",
                                           folder_ / "two.png",  "--size", "800x400"};
  ASSERT_EQ(mesh_snapshot(panels).status, 0);
  EXPECT_GT(read_pixels(folder_ / "two.png", 0, 0.5).grey, 0.3);
  EXPECT_EQ(read_pixels(folder_ / "two.png", 0.5, 1).white, 1);
  std::vector<std::string> labelled = panels;
  for (const char* word : {"--label", "a cube", "--label", "nothing at all"}) labelled.push_back(word);
  ASSERT_EQ(mesh_snapshot(labelled).status, 0);
  const Pixels empty = read_pixels(folder_ / "two.png", 0.5, 1);
  EXPECT_LT(empty.white, 0.999);  // the text
  EXPECT_GT(empty.white, 0.95);
}

TEST_F(MeshSnapshot, LargeCoordinatesAreDrawnSharp) {
  Model model = cube(false, false);
  for (Point& p : model.positions) p = {p[0] * 0.01 + 500000.1, p[1] * 0.01 + 4649776.7, p[2] * 0.01 + 123.4};
  io::write_mesh(folder_ / "far.ply", model);
  ASSERT_EQ(mesh_snapshot({folder_ / "far.ply", "-o", folder_ / "far.png"}).status, 0);
  const Pixels pixels = read_pixels(folder_ / "far.png");
  EXPECT_GT(pixels.grey, 0.4);
  EXPECT_EQ(pixels.red, 0);
}

/// Decodes a GIF and returns how many pictures there are.
int split_gif(const std::string& path, std::vector<Picture>& pictures) {
  int error = 0;
  GifFileType* gif = DGifOpenFileName(path.c_str(), &error);
  if (!gif) return 0;
  EXPECT_EQ(DGifSlurp(gif), GIF_OK);
  for (int i = 0; i < gif->ImageCount; ++i) {
    const SavedImage& image = gif->SavedImages[i];
    Picture picture{image.ImageDesc.Width, image.ImageDesc.Height, {}};
    for (int k = 0; k < picture.width * picture.height; ++k) {
      const GifColorType& colour = gif->SColorMap->Colors[image.RasterBits[k]];
      picture.pixels.push_back({colour.Red, colour.Green, colour.Blue});
    }
    pictures.push_back(std::move(picture));
  }
  const int count = gif->ImageCount;
  DGifCloseFile(gif, nullptr);
  return count;
}

TEST_F(MeshSnapshot, PaintsFacesByTheirDistanceToAReference) {
  Model raised = cube(false, false);
  for (const int top : {2, 3, 6, 7}) raised.positions[top][1] = 1.5;  // half a unit more
  io::write_mesh(folder_ / "cube.ply", cube(false, false));
  io::write_mesh(folder_ / "raised.ply", raised);
  const auto paint = [&](const std::string& mesh, const std::string& range) {
    const Outcome outcome =
        mesh_snapshot({folder_ / mesh, "--reference", folder_ / "cube.ply", "-o", folder_ / "painted.png",
                       "--range", range, "--view", "0,90", "--size", "400x400"});  // from above
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return read_pixels(folder_ / "painted.png", 0.1, 0.7);
  };
  EXPECT_GT(paint("raised.ply", "0.5").blue, 0.5);  // the top is at the end of the scale
  EXPECT_EQ(paint("cube.ply", "0.5").blue, 0);      // nothing to be seen of itself
  EXPECT_LT(paint("raised.ply", "50").blue, 0.01);  // nearly nothing on a long scale
  const Pixels bar = read_pixels(folder_ / "painted.png", 0.74, 1);
  EXPECT_GT(bar.blue, 0.01);  // the scale's end
  EXPECT_LT(bar.blue, 0.5);
}

TEST_F(MeshSnapshot, PaintsPointsByTheirDistanceToTheMesh) {
  io::write_mesh(folder_ / "cube.ply", cube(false, false));
  std::ofstream cloud(folder_ / "cloud.xyz");
  for (int i = 0; i < 40; ++i) cloud << i / 40.0 << " 1 0.2\n" << i / 40.0 << " 1.6 0.8\n";
  cloud.close();
  std::vector<std::string> arguments = {folder_ / "cube.ply",
                                        "--points",
                                        folder_ / "cloud.xyz",
                                        "-o",
                                        folder_ / "points.png",
                                        "--view",
                                        "0,90"};
  ASSERT_EQ(mesh_snapshot(arguments).status, 0);
  const double plain = read_pixels(folder_ / "points.png", 0, 0.8).blue;
  arguments.push_back("--deviation");
  ASSERT_EQ(mesh_snapshot(arguments).status, 0);
  const double far_only = read_pixels(folder_ / "points.png", 0, 0.8).blue;
  EXPECT_GT(far_only, 0.2 * plain);  // those that are off
  EXPECT_LT(far_only, 0.8 * plain);  // those on the mesh are pale
}

TEST_F(MeshSnapshot, ATurntableIsASequenceOrAGifOfTheSamePictures) {
  io::write_mesh(folder_ / "open.ply", cube(true, false));
  const std::vector<std::string> turn = {
      folder_ / "open.ply", "--turntable", "4", "--size", "200x200", "--view", "45,20", "--up", "z", "-o"};
  auto sequence = turn, animation = turn;
  sequence.push_back(folder_ / "turn.png");
  animation.push_back(folder_ / "turn.gif");
  Outcome outcome = mesh_snapshot(sequence);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_FALSE(fs::exists(folder_ / "turn.png"));
  EXPECT_EQ(folder_.count(), 5u);
  outcome = mesh_snapshot(animation);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  std::vector<Picture> pictures;
  ASSERT_EQ(split_gif(folder_ / "turn.gif", pictures), 4);
  for (int i = 0; i < 4; ++i) {
    const Pixels still = read_pixels(folder_ / ("turn_00" + std::to_string(i) + ".png"));
    const Pixels moving = count_pixels(pictures[i]);
    EXPECT_EQ(moving.width, 200);
    EXPECT_NEAR(still.white, moving.white, 0.01);
    EXPECT_NEAR(still.grey, moving.grey, 0.02);
    EXPECT_GT(still.grey, 0.2);
    // A cube looks alike from its four sides, but one of them is the hole.
    EXPECT_NEAR(still.white, read_pixels(folder_ / "turn_000.png").white, 0.01);
  }
  EXPECT_NE(read_pixels(folder_ / "turn_000.png").red, read_pixels(folder_ / "turn_001.png").red);
}

TEST_F(MeshSnapshot, PlaysTheFilmOfARealScan) {
  ASSERT_EQ(run_program({PCD_TO_MESH, TEST_DATA "/bun0.pcd", folder_ / "bunny.ply", "--init", "sphere",
                         "--max-steps", "4", "--dump-steps", folder_ / "steps"})
                .status,
            0);
  const std::size_t steps = std::distance(fs::directory_iterator(folder_ / "steps"), {});
  ASSERT_GE(steps, 3u);
  const Outcome outcome =
      mesh_snapshot({"--steps", folder_ / "steps", folder_ / "bunny.ply", "--points", TEST_DATA "/bun0.pcd",
                     "--grey-backs", "--size", "400x200", "-o", folder_ / "film.gif"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  std::vector<Picture> pictures;
  ASSERT_EQ(split_gif(folder_ / "film.gif", pictures), static_cast<int>(steps));
  // The film shrinks from the sphere, and what is beside it stays.
  const double first = count_pixels(pictures.front(), 0, 0.5).white,
               last = count_pixels(pictures.back(), 0, 0.5).white;
  EXPECT_GT(last, first + 0.1);
  EXPECT_NEAR(count_pixels(pictures.front(), 0.5, 1).white, count_pixels(pictures.back(), 0.5, 1).white,
              1e-9);

  // During a turn the evolution goes on.
  ASSERT_EQ(mesh_snapshot({"--steps", folder_ / "steps", "--turntable", "6", "--size", "100x100", "-o",
                           folder_ / "turn.png"})
                .status,
            0);
  EXPECT_GT(read_pixels(folder_ / "turn_005.png").white, read_pixels(folder_ / "turn_000.png").white + 0.1);
  EXPECT_FALSE(fs::exists(folder_ / "turn_006.png"));
}

TEST_F(MeshSnapshot, ShowsTheColoursOfAFile) {
  Model model = cube(false, false);
  model.colours.assign(8, {30, 60, 220});
  io::write_mesh(folder_ / "blue.ply", model);
  ASSERT_EQ(mesh_snapshot({folder_ / "blue.ply", "-o", folder_ / "plain.png"}).status, 0);
  ASSERT_EQ(mesh_snapshot({folder_ / "blue.ply", "--colours", "-o", folder_ / "blue.png"}).status, 0);
  EXPECT_EQ(read_pixels(folder_ / "plain.png").blue, 0);
  EXPECT_GT(read_pixels(folder_ / "blue.png").blue, 0.2);
}

TEST_F(MeshSnapshot, FailsInOneSentence) {
  io::write_mesh(folder_ / "cube.ply", cube(false, false));
  const std::string mesh = folder_ / "cube.ply", png = folder_ / "cube.png";
  const std::vector<std::pair<int, std::vector<std::string>>> cases = {
      {2, {}},
      {2, {mesh}},
      {2, {"-o", png}},
      {2, {mesh, "-o", folder_ / "cube.jpg"}},
      {2, {mesh, "-o", png, "--size", "big"}},
      {2, {mesh, "-o", png, "--size", "99999x9"}},
      {2, {mesh, "-o", png, "--view", "1"}},
      {2, {mesh, "-o", png, "--view", "0,91"}},
      {2, {mesh, "-o", png, "--columns", "0"}},
      {2, {mesh, "-o", png, "--up", "x"}},
      {2, {mesh, "-o", png, "--fit", "tight"}},
      {2, {mesh, mesh, "-o", png, "--label", "only one"}},
      {2, {mesh, "-o", png, "--nonsense"}},
      {2, {mesh, "-o", png, "--deviation"}},
      {2, {mesh, "-o", png, "--range", "1"}},
      {2, {mesh, "-o", png, "--reference", mesh, "--range", "0"}},
      {2, {mesh, "-o", png, "--turntable", "1"}},
      {2, {mesh, "-o", png, "--turntable", "721"}},
      {2, {mesh, "-o", png, "--fps", "0"}},
      {2, {mesh, "-o", png, "--label", "one", "--steps", folder_.path().string()}},
      {1, {mesh, "-o", png, "--steps", folder_.path().string()}},  // no step in it
      {1, {mesh, "-o", png, "--steps", folder_ / "missing"}},
      {1, {mesh, "-o", png, "--reference", TEST_DATA "/spot_10k.ply"}},  // points only
      {1, {mesh, "-o", folder_ / "t.gif", "--turntable", "720", "--size", "4000x4000"}},
      {1, {folder_ / "missing.ply", "-o", png}},
      {1, {TEST_DATA "/spot_10k.ply", "-o", png}},  // points only
      {1, {mesh, "-o", folder_ / "no/such/cube.png"}},
      {1, {mesh, "-o", png, "--points", folder_ / "missing.pcd"}},
  };
  for (const auto& [status, arguments] : cases) {
    // None gets as far as drawing, so that a display that does not exist will do.
    std::vector<std::string> command = {"/usr/bin/env", "DISPLAY=:none", MESH_SNAPSHOT};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const Outcome outcome = run_program(command);
    EXPECT_EQ(outcome.status, status);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(outcome.err.rfind("mesh_snapshot: ", 0), 0u) << outcome.err;
    EXPECT_EQ(folder_.count(), 1u);
  }
}

TEST_F(MeshSnapshot, SaysThatItNeedsADisplay) {
  io::write_mesh(folder_ / "cube.ply", cube(false, false));
  const Outcome outcome = run_program(
      {"/usr/bin/env", "-u", "DISPLAY", MESH_SNAPSHOT, folder_ / "cube.ply", "-o", folder_ / "cube.png"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_NE(outcome.err.find("xvfb-run"), std::string::npos);
}

}  // namespace
}  // namespace filmsticking::test
