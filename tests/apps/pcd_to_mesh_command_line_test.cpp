// SPDX-License-Identifier: GPL-3.0-or-later
// Every option, and what is said of wrong ones and of files that are no clouds.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "io/formats.h"
#include "support/pcd_to_mesh.h"

namespace filmsticking::test {
namespace {

namespace fs = std::filesystem;

TEST(PcdToMesh, EveryOptionWorks) {
  const std::vector<std::vector<std::string>> choices = {
      {"--preset", "default"},    {"--preset", "paper"},
      {"--preset", "rd"},         {"--init", "sphere"},
      {"--init", "wrap"},         {"--init", "carve"},
      {"--field", "poisson"},     {"--field", "sculpt"},
      {"--field", "none"},        {"--ring", "smooth"},
      {"--ring", "nearest"},      {"--virtual-sites", "0"},
      {"--virtual-sites", "200"}, {"--virtual-sites", "adaptive"},
      {"--no-weights"},           {"--keep-outliers"},
      {"--no-sharp-edges"},       {"--no-insert"},
      {"--max-steps", "3"},       {"--max-rounds", "1"},
  };
  const ScratchFolder folder;
  const Model cloud = io::read_cloud(kBunny);
  for (const auto& choice : choices) {
    std::vector<std::string> arguments = {kBunny, folder / "mesh.ply"};
    arguments.insert(arguments.end(), choice.begin(), choice.end());
    fs::remove(folder / "mesh.ply");
    const Outcome outcome = pcd_to_mesh(arguments);
    ASSERT_EQ(outcome.status, 0) << choice[0] << " " << choice.back() << ": " << outcome.err;
    SCOPED_TRACE(choice[0] + " " + choice.back());
    expect_surface_through(io::read_mesh(folder / "mesh.ply"), cloud);
  }
}

TEST(PcdToMesh, HelpAndVersionGoToStdout) {
  for (const char* option : {"--help", "--version"}) {
    const Outcome outcome = pcd_to_mesh({option});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_NE(outcome.out.find("pcd_to_mesh"), std::string::npos);
    EXPECT_EQ(outcome.err, "");
  }
  const std::string help = pcd_to_mesh({"--help"}).out;
  for (const char* option :
       {"--report",     "--preset",    "--init",      "--field",      "--ring",    "--virtual-sites",
        "--no-weights", "--no-insert", "--max-steps", "--max-rounds", "--threads", "--dump-steps",
        "--version",    "--crop",      "--sor",       "--voxel",      "--mls",     "--out-dir",
        "--to",         "--format",    "--jobs"})
    EXPECT_NE(help.find(option), std::string::npos) << option;
}

TEST(PcdToMesh, WrongCommandLinesFailInOneSentence) {
  const ScratchFolder folder;
  const std::string mesh = folder / "mesh.ply";
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {},
           {kBunny},
           {kBunny, mesh, "third"},
           {kBunny, ""},
           {kBunny, mesh, "--out-dir", ""},
           {"--out-dir", folder.path().string()},
           {kBunny, mesh, "--to", "ply"},
           {kBunny, mesh, "--format", "las9"},
           {kBunny, mesh, "--columns", "x,y"},
           {kBunny, mesh, "--columns", "x,,z"},
           {kBunny, mesh, "--merge", "--out-dir", folder.path().string()},
           {"-", "-", mesh, "--merge"},
           {kBunny, folder.path().string(), "--to", "xyz"},
           {kBunny, kBunny, folder.path().string()},
           {"-", folder.path().string()},
           {kBunny, kSpot, folder.path().string(), "--dump-steps", folder / "steps"},
           {kBunny, mesh, "--jobs", "-1"},
           {kBunny, mesh, "--voxel", "0"},
           {kBunny, mesh, "--voxel", "wide"},
           {kBunny, mesh, "--sor", "16"},
           {kBunny, mesh, "--crop", "0,0,0,1,1"},
           {kBunny, mesh, "--crop", "1,0,0,0,1,1"},
           {kBunny, mesh, "--mls", "-1"},
           {kBunny, mesh, "--nonsense"},
           {kBunny, mesh, "--thr", "1"},
           {kBunny, mesh, "--threads"},
           {kBunny, mesh, "--threads", "-1"},
           {kBunny, mesh, "--threads", "two"},
           {kBunny, mesh, "--threads", "99999999999"},
           {kBunny, mesh, "--max-steps", "0"},
           {kBunny, mesh, "--max-rounds", "0"},
           {kBunny, mesh, "--virtual-sites", "-3"},
           {kBunny, mesh, "--virtual-sites", "many"},
           {kBunny, mesh, "--init", "cube"},
           {kBunny, mesh, "--field", "magnetic"},
           {kBunny, mesh, "--ring", "wedding"},
           {kBunny, mesh, "--preset", "fast"},
           {kBunny, mesh, "--threads", "1", "--threads", "2"},
       })
    expect_failure(arguments, folder, 2);
}

TEST(PcdToMesh, BadInputsFailInOneSentence) {
  const ScratchFolder folder;
  const std::map<std::string, std::string> files = {
      {"empty.ply", ""},
      {"noise.ply", "noise"},
      {"noise.pcd", "noise"},
      {"noise.stl", "noise"},
      {"noise.obj", "noise"},
      {"noise.vtk", "noise"},
      {"noise.xyz", "noise"},
      {"three.xyz", "0 0 0\n1 0 0\n0 1 0\n"},
      {"repeated.xyz", "0 0 0\n1 0 0\n0 1 0\n0 1 0\n0 1 0\n"},
      {"flat.xyz", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 1 0\n"},
      {"nan.xyz", "nan nan nan\nnan nan nan\nnan nan nan\nnan nan nan\nnan nan nan\n"},
      {"unknown.las", "LASF"},
  };
  for (const auto& [name, text] : files) std::ofstream(folder / name) << text;
  for (const auto& [name, text] : files) expect_failure({folder / name, folder / "mesh.ply"}, folder, 1);
  expect_failure({folder / "missing.ply", folder / "mesh.ply"}, folder, 1);
  expect_failure({folder.path().string(), folder / "mesh.ply"}, folder, 1);
}

TEST(PcdToMesh, BadOutputsFailInOneSentence) {
  const ScratchFolder folder;
  fs::copy_file(kBunny, folder / "cloud.pcd");
  io::write_mesh(folder / "cloud.ply", Model(io::read_cloud(kBunny)));
  expect_failure({kBunny, folder / "mesh.foo"}, folder, 1);
  expect_failure({kBunny, folder / "mesh"}, folder, 1);
  expect_failure({kBunny, folder / "no/such/mesh.ply"}, folder, 1);
  expect_failure({folder / "cloud.ply", folder / "cloud.ply"}, folder, 1);
  expect_failure({kBunny, folder / "mesh.ply", "--report", folder / "no/such/report.json"}, folder, 1);
  expect_failure({kBunny, folder / "mesh.ply", "--dump-steps", folder / "cloud.pcd"}, folder, 1);
}

}  // namespace
}  // namespace filmsticking::test
