// SPDX-License-Identifier: GPL-3.0-or-later
// pcd_to_mesh as a user runs it, on real clouds.
#include <gtest/gtest.h>
#include <pcl/io/pcd_io.h>
#include <vtkCell.h>
#include <vtkDataArray.h>
#include <vtkDataObjectTreeIterator.h>
#include <vtkGLTFReader.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <thread>

#include "filters/filter_chain.h"
#include "io/files.h"
#include "io/formats.h"
#include "support/model.h"
#include "support/run_program.h"
#include "support/scratch_folder.h"
#include "support/surface_check.h"

namespace filmsticking::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const std::string kBunny = TEST_DATA "/bun0.pcd", kSpot = TEST_DATA "/spot_10k.ply";

Outcome pcd_to_mesh(std::vector<std::string> arguments,
                    const std::function<void(pid_t)>& while_running = nullptr) {
  arguments.insert(arguments.begin(), PCD_TO_MESH);
  return run_program(arguments, while_running);
}

Json read_json(const std::string& path) { return Json::parse(io::read_file(path)); }

void expect_surface_through(const Model& mesh, const Model& cloud) {
  const Mesh surface{mesh.positions, mesh.triangles};
  EXPECT_EQ(surface_fault(surface), "");
  EXPECT_GT(signed_volume(surface), 0);
  const std::set<Point> points(cloud.positions.begin(), cloud.positions.end());
  for (const Point& p : mesh.positions) ASSERT_TRUE(points.count(p));
}

/// One sentence on stderr, a status that is not 0, and nothing in the folder that was not there.
void expect_failure(const std::vector<std::string>& arguments, const ScratchFolder& folder, int status) {
  const std::size_t before = folder.count();
  const Outcome outcome = pcd_to_mesh(arguments);
  EXPECT_EQ(outcome.status, status) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_EQ(outcome.err.rfind("pcd_to_mesh: ", 0), 0u) << outcome.err;
  EXPECT_GT(outcome.err.size(), 20u);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(folder.count(), before) << outcome.err;
}

TEST(PcdToMesh, MakesAMeshOfBun0) {
  const ScratchFolder folder;
  const Outcome outcome = pcd_to_mesh({kBunny, folder / "bunny.ply"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");  // no progress bar off a terminal
  EXPECT_NE(outcome.out.find("397 points"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("closed  yes, manifold"), std::string::npos) << outcome.out;
  expect_surface_through(io::read_mesh(folder / "bunny.ply"), io::read_cloud(kBunny));
  EXPECT_EQ(folder.count(), 1u);
}

TEST(PcdToMesh, MakesAMeshOfSpot) {
  const ScratchFolder folder;
  const Outcome outcome = pcd_to_mesh({kSpot, folder / "spot.ply", "--report", folder / "spot.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Model mesh = io::read_mesh(folder / "spot.ply");
  expect_surface_through(mesh, io::read_cloud(kSpot));
  EXPECT_GT(mesh.positions.size(), 9900u);

  const Json report = read_json(folder / "spot.json");
  EXPECT_EQ(report.at("status").get<std::string>(), "Ok");
  EXPECT_EQ(report.at("message").get<std::string>(), "");
  EXPECT_EQ(report.at("points").get<int>(), 10000);
  EXPECT_EQ(report.at("sites").get<int>(), 10000);
  EXPECT_EQ(report.at("vertices").get<std::size_t>(), mesh.positions.size());
  EXPECT_EQ(report.at("triangles").get<std::size_t>(), mesh.triangles.size());
  EXPECT_EQ(report.at("interpolated").get<int>(), report.at("vertices").get<int>());
  EXPECT_GT(report.at("interpolated_share").get<double>(), 0.99);
  EXPECT_TRUE(report.at("closed").get<bool>());
  EXPECT_TRUE(report.at("manifold").get<bool>());
  EXPECT_EQ(report.at("genus").get<int>(), 0);
  EXPECT_EQ(report.at("components").get<int>(), 1);
  EXPECT_GT(report.at("seconds").get<double>(), 0);
  EXPECT_GT(report.at("peak_memory_bytes").get<double>(), 1e6);
  EXPECT_EQ(report.at("steps").size(), 0u);  // a carved surface needs no film steps
  ASSERT_GT(report.at("rooms").size(), 0u);
  for (const Json& stage : report.at("rooms")) EXPECT_NE(stage.at("room").get<std::string>(), "");
}

TEST(PcdToMesh, ReadsEveryFormatToTheSameMesh) {
  const ScratchFolder folder;
  const Model cloud = io::read_cloud(kBunny);
  io::write_mesh(folder / "cloud.ply", Model(cloud.positions, {}, {}));
  io::write_mesh(folder / "cloud.obj", Model(cloud.positions, {}, {}));
  for (const char* name : {"cloud.xyz", "cloud.TXT"}) {
    std::ofstream text(folder / name);
    text.precision(17);
    for (const Point& p : cloud.positions) text << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  }
  pcl::PCDWriter().writeBinary(folder / "cloud.pcd", io::make_cloud(cloud.positions));
  ASSERT_EQ(pcd_to_mesh({folder / "cloud.pcd", folder / "expected.ply"}).status, 0);
  const std::string expected = io::read_file(folder / "expected.ply");
  for (const char* name : {"cloud.ply", "cloud.obj", "cloud.xyz", "cloud.TXT"}) {
    const Outcome outcome = pcd_to_mesh({folder / name, folder / "mesh.ply"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(io::read_file(folder / "mesh.ply") == expected) << name;
  }
}

TEST(PcdToMesh, WritesEveryFormatWithTheSameBits) {
  const ScratchFolder folder;
  ASSERT_EQ(pcd_to_mesh({kBunny, folder / "mesh.ply"}).status, 0);
  const Model expected = io::read_mesh(folder / "mesh.ply");
  for (const char* name : {"mesh.obj", "mesh.vtk", "mesh.stl"}) {
    const Outcome outcome = pcd_to_mesh({kBunny, folder / name});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const Model mesh = io::read_mesh(folder / name);
    const auto corner_points = [](const Model& model) {  // STL keeps no numbers of vertices
      std::vector<Point> points;
      for (const Triangle& t : model.triangles)
        for (const int k : t) points.push_back(model.positions[k]);
      return points;
    };
    EXPECT_EQ(corner_points(mesh), corner_points(expected)) << name;
    EXPECT_EQ(mesh.positions.size(), expected.positions.size());
  }
}

TEST(PcdToMesh, LargeDoubleCoordinatesAreKept) {
  const ScratchFolder folder;
  Model cloud = io::read_cloud(kBunny);
  for (Point& p : cloud.positions) p = {p[0] * 10 + 500000.1, p[1] * 10 + 4649776.7, p[2] * 10 + 123.4};
  io::write_mesh(folder / "cloud.ply", cloud);
  for (const char* name : {"mesh.ply", "mesh.obj", "mesh.vtk"}) {
    const Outcome outcome = pcd_to_mesh({folder / "cloud.ply", folder / name});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    expect_surface_through(io::read_mesh(folder / name), cloud);
  }
}

TEST(PcdToMesh, ColoursGoWithTheirPoints) {
  const ScratchFolder folder;
  Model cloud = io::read_cloud(kBunny);
  std::map<Point, io::Colour> colour_of;
  for (std::size_t i = 0; i < cloud.positions.size(); ++i) {
    cloud.colours.push_back({static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i / 2), 77});
    colour_of[cloud.positions[i]] = cloud.colours.back();
  }
  io::write_mesh(folder / "cloud.ply", cloud);
  ASSERT_EQ(pcd_to_mesh({folder / "cloud.ply", folder / "mesh.ply"}).status, 0);
  const Model mesh = io::read_mesh(folder / "mesh.ply");
  ASSERT_EQ(mesh.colours.size(), mesh.positions.size());
  for (std::size_t k = 0; k < mesh.positions.size(); ++k)
    EXPECT_EQ(mesh.colours[k], colour_of.at(mesh.positions[k]));
}

TEST(PcdToMesh, StabilityIsAColourAndInTheReport) {
  const ScratchFolder folder;
  const Outcome outcome =
      pcd_to_mesh({kSpot, folder / "spot.ply", "--stability", "--report", folder / "spot.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Model mesh = io::read_mesh(folder / "spot.ply");
  ASSERT_EQ(mesh.colours.size(), mesh.positions.size());
  std::size_t white = 0;
  for (const auto& colour : mesh.colours) {
    EXPECT_EQ(colour[0], 255);
    EXPECT_EQ(colour[1], colour[2]);
    white += colour[1] == 255 ? 1 : 0;
  }
  EXPECT_GT(2 * white, mesh.colours.size());
  EXPECT_LT(white, mesh.colours.size());
  EXPECT_GT(read_json(folder / "spot.json").at("stability").get<double>(), 0.8);
}

/// The normals of all points; empty where the file has none.
std::vector<Point> normals_in(const pcl::PCLPointCloud2& cloud) {
  std::vector<Point> normals;
  const pcl::PCLPointField* x = io::find_field(cloud, "normal_x");
  for (std::size_t i = 0; x != nullptr && i < io::size_of(cloud); ++i) {
    float n[3];
    std::memcpy(n, io::bytes_of(cloud, i) + x->offset, sizeof n);
    normals.push_back({n[0], n[1], n[2]});
  }
  return normals;
}

TEST(PcdToMesh, NormalsOfAllPointsAndOfTheVerticesAreWritten) {
  const ScratchFolder folder;
  Model ball;
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 2000; ++i) {
    const double x = normal(random), y = normal(random), z = normal(random), r = std::hypot(x, y, z);
    ball.positions.push_back({x / r, y / r, z / r});
  }
  ball.positions.push_back({0, 0, 9});  // an outlier
  io::write_mesh(folder / "ball.ply", ball);
  for (const std::string kind : {"ply", "pcd"}) {
    const std::string points = folder / ("points." + kind);
    const Outcome outcome =
        pcd_to_mesh({folder / "ball.ply", folder / "mesh.ply", "--normals", "--points-out", points});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const io::Cloud cloud = io::read_cloud(points);
    EXPECT_EQ(io::positions_of(cloud.points), ball.positions);
    const std::vector<Point> normals = normals_in(cloud.points);
    ASSERT_EQ(normals.size(), ball.positions.size());
    for (std::size_t i = 0; i < normals.size(); ++i) {
      const Point& p = ball.positions[i];
      const Point& n = normals[i];
      EXPECT_GT(p[0] * n[0] + p[1] * n[1] + p[2] * n[2], 0.9);
    }
  }
  EXPECT_EQ(normals_in(io::read_mesh(folder / "mesh.ply").cloud).size(), 2000U);
  ASSERT_EQ(pcd_to_mesh({folder / "ball.ply", folder / "mesh.ply", "--points-out", folder / "p.xyz"}).status,
            0);
  std::ifstream text(folder / "p.xyz");
  double x[6];
  for (const Point& p : ball.positions) {
    for (double& number : x) text >> number;
    EXPECT_EQ((Point{x[0], x[1], x[2]}), p);
    EXPECT_GT(p[0] * x[3] + p[1] * x[4] + p[2] * x[5], 0.9);
  }
  EXPECT_TRUE(normals_in(io::read_mesh(folder / "mesh.ply").cloud).empty());  // not asked for
}

TEST(PcdToMesh, HolesAreClosedUpToADiameter) {
  const ScratchFolder folder;
  Model ball;
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  while (ball.positions.size() < 6000) {
    const double x = normal(random), y = normal(random), z = normal(random), r = std::hypot(x, y, z);
    if (std::hypot(x, y) > (z > 0 ? 0.3 : 0.6) * r) ball.positions.push_back({x / r, y / r, z / r});
  }
  io::write_mesh(folder / "ball.ply", ball);
  // The diagonal of the box is about 3.4.
  const std::pair<const char*, int> cases[] = {{"0.4", 2}, {"0.9", 1}, {"12%", 2}, {"27%", 1}, {"50%", 0}};
  for (const auto& [most, open] : cases) {
    SCOPED_TRACE(most);
    const Outcome outcome = pcd_to_mesh({folder / "ball.ply", folder / "mesh.ply", "--close-holes", most,
                                         "--report", folder / "report.json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const Json report = read_json(folder / "report.json");
    EXPECT_EQ(report.at("boundary_loops").get<int>(), open);
    ASSERT_EQ(report.at("holes").size(), 2u);
    EXPECT_EQ(report.at("holes")[0].at("closed").get<bool>(), open == 0);
    EXPECT_EQ(outcome.out.find("lids") == std::string::npos, open == 2) << outcome.out;
  }
  for (const char* wrong : {"0", "-1", "x", "", "1,2", "inf", "%"})
    EXPECT_EQ(pcd_to_mesh({folder / "ball.ply", folder / "m.ply", "--close-holes", wrong}).status, 2)
        << wrong;
}

TEST(PcdToMesh, NormalsThatCannotBeWrittenAreRefusedBeforeTheWork) {
  const ScratchFolder folder;
  expect_failure({kBunny, folder / "m.obj", "--normals"}, folder, 1);
  expect_failure({kBunny, folder / "m.ply", "--points-out", folder / "p.obj"}, folder, 1);
  expect_failure({kBunny, folder / "m.ply", "--points-out", folder / "m.ply"}, folder, 1);
  EXPECT_EQ(pcd_to_mesh({kBunny, kSpot, folder / "", "--points-out", folder / "p.ply"}).status, 2);
}

TEST(PcdToMesh, ColoursGoIntoEveryFormatThatHasThem) {
  const ScratchFolder folder;
  Model cloud = io::read_cloud(kBunny);
  std::map<Point, io::Colour> colour_of;
  for (std::size_t i = 0; i < cloud.positions.size(); ++i) {
    cloud.colours.push_back({static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i / 2), 77});
    colour_of[cloud.positions[i]] = cloud.colours.back();
  }
  io::write_mesh(folder / "cloud.ply", cloud);
  for (const char* name : {"mesh.obj", "mesh.vtk"}) {
    ASSERT_EQ(pcd_to_mesh({folder / "cloud.ply", folder / name}).status, 0);
    const Model mesh = io::read_mesh(folder / name);
    ASSERT_EQ(mesh.colours.size(), mesh.positions.size()) << name;
    for (std::size_t k = 0; k < mesh.positions.size(); ++k)
      EXPECT_EQ(mesh.colours[k], colour_of.at(mesh.positions[k])) << name;
  }
}

/// The bunny with a normal, an intensity, a label and a field that nobody has heard of at every point.
pcl::PCLPointCloud2 bunny_with_fields() {
  using Type = pcl::PCLPointField;
  const std::vector<Point> positions = io::positions_of(io::read_cloud(kBunny).points);
  std::vector<pcl::PCLPointField> fields;
  std::size_t step = 0;
  const auto add = [&](const char* name, std::uint8_t type) {
    fields.push_back(io::make_field(name, step, type));
    step += io::size_of(io::Scalar{type});
  };
  for (const char* name : {"x", "y", "z", "normal_x", "normal_y", "normal_z", "intensity"})
    add(name, Type::FLOAT32);
  add("label", Type::UINT32);
  add("gps_seconds", Type::FLOAT64);
  add("ring", Type::UINT16);
  pcl::PCLPointCloud2 cloud = io::make_rows(fields, step, positions.size());
  const io::PositionFields places(cloud);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    std::uint8_t* point = &cloud.data[i * step];
    places.store(positions[i], point);
    const auto number = static_cast<float>(i);
    const float values[4] = {0.1F * number, -0.2F, 1 / (number + 1), 0.3F * number};
    const std::uint32_t label = 4000000000U + static_cast<std::uint32_t>(i);
    const double seconds = 1.6e9 + 1e-6 * static_cast<double>(i);
    const auto ring = static_cast<std::uint16_t>(60000 + i);
    std::memcpy(point + 12, values, sizeof values);
    std::memcpy(point + 28, &label, sizeof label);
    std::memcpy(point + 32, &seconds, sizeof seconds);
    std::memcpy(point + 40, &ring, sizeof ring);
  }
  return cloud;
}

/// Every vertex of the mesh has the fields of the input's point at its place, in type and value.
void expect_fields_kept(const pcl::PCLPointCloud2& mesh, const pcl::PCLPointCloud2& cloud) {
  std::map<Point, std::size_t> point_at;
  const std::vector<Point> points = io::positions_of(cloud), vertices = io::positions_of(mesh);
  for (std::size_t i = 0; i < points.size(); ++i) point_at[points[i]] = i;
  EXPECT_GT(vertices.size(), 300u);
  for (const pcl::PCLPointField& field : cloud.fields) {
    const pcl::PCLPointField* kept = io::find_field(mesh, field.name.c_str());
    ASSERT_NE(kept, nullptr) << field.name;
    ASSERT_EQ(kept->datatype, field.datatype) << field.name;
    for (std::size_t k = 0; k < vertices.size(); ++k)
      ASSERT_EQ(std::memcmp(io::bytes_of(mesh, k) + kept->offset,
                            io::bytes_of(cloud, point_at.at(vertices[k])) + field.offset,
                            io::size_of(io::Scalar{field.datatype})),
                0)
          << field.name << " of vertex " << k;
  }
}

TEST(PcdToMesh, EveryFieldGoesWithItsPointFromPcdAndPlyToPly) {
  const ScratchFolder folder;
  const pcl::PCLPointCloud2 cloud = bunny_with_fields();
  pcl::PCDWriter().writeBinary(folder / "cloud.pcd", cloud);
  io::write_mesh(folder / "cloud.ply", cloud, {});
  for (const char* name : {"cloud.pcd", "cloud.ply"}) {
    SCOPED_TRACE(name);
    const Outcome outcome = pcd_to_mesh({folder / name, folder / "mesh.ply"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    expect_fields_kept(io::read_mesh(folder / "mesh.ply").cloud, cloud);
    // The names that PLY's readers know.
    const std::string bytes = io::read_file(folder / "mesh.ply");
    for (const char* property :
         {"float nx", "float intensity", "uint label", "double gps_seconds", "ushort ring"})
      EXPECT_NE(bytes.find(std::string("property ") + property + "\n"), std::string::npos) << property;
  }
}

TEST(PcdToMesh, EveryFieldIsKeptBesideDoubleCoordinatesAndBehindFilters) {
  const ScratchFolder folder;
  const pcl::PCLPointCloud2 cloud = bunny_with_fields();
  std::vector<Point> far = io::positions_of(cloud);
  for (Point& p : far) p = {p[0] + 500000.1, p[1] + 4649776.7, p[2] + 123.4};
  const pcl::PCLPointCloud2 moved = io::with_positions(cloud, far);
  pcl::PCDWriter().writeBinary(folder / "cloud.pcd", moved);
  const Outcome outcome = pcd_to_mesh({folder / "cloud.pcd", folder / "mesh.ply", "--sor", "16,3"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  expect_fields_kept(io::read_mesh(folder / "mesh.ply").cloud, moved);
}

TEST(PcdToMesh, TheMeshDoesNotDependOnTheThreads) {
  const ScratchFolder folder;
  ASSERT_EQ(pcd_to_mesh({kBunny, folder / "one.ply", "--threads", "1"}).status, 0);
  ASSERT_EQ(pcd_to_mesh({kBunny, folder / "two.ply", "--threads=2"}).status, 0);
  EXPECT_TRUE(io::read_file(folder / "one.ply") == io::read_file(folder / "two.ply"));
}

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

TEST(PcdToMesh, DumpsTheFilmOfEachStep) {
  const ScratchFolder folder;
  const Outcome outcome = pcd_to_mesh({kBunny, folder / "mesh.ply", "--init", "sphere", "--dump-steps",
                                       folder / "new/steps", "--report", folder / "report.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json report = read_json(folder / "report.json");
  ASSERT_GT(report.at("steps").size(), 0u);
  for (const Json& step : report.at("steps")) {
    for (const char* field : {"round", "attracted", "virtual_left", "weighted", "held"})
      EXPECT_GE(step.at(field).get<int>(), 0);
    EXPECT_GE(step.at("seconds").get<double>(), 0);
  }
  EXPECT_TRUE(fs::exists(folder / "new/steps/step_000.ply"));
  EXPECT_TRUE(fs::exists(folder / "new/steps/step_001.ply"));
  for (const auto& entry : fs::directory_iterator(folder / "new/steps")) {
    // A film is closed: every edge is run through as often in either direction. It may touch itself.
    const Model film = io::read_mesh(entry.path().string());
    std::map<std::pair<Point, Point>, int> edges;
    for (const Triangle& t : film.triangles)
      for (int k = 0; k < 3; ++k) {
        const Point &from = film.positions[t[k]], &to = film.positions[t[(k + 1) % 3]];
        ++edges[{from, to}], --edges[{to, from}];
      }
    EXPECT_FALSE(edges.empty()) << entry.path();
    for (const auto& [edge, count] : edges) ASSERT_EQ(count, 0) << entry.path();
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

TEST(PcdToMesh, FiltersRunBeforeTheSurface) {
  const ScratchFolder folder;
  const std::string milk = TEST_DATA "/milk.pcd";
  filters::FilterOptions wanted;
  set_filter(wanted, "crop", "-1,-1,0.5,1,1,2");
  set_filter(wanted, "sor", "16,2");
  set_filter(wanted, "voxel", "0.006");
  const Model left = filters::filter(io::read_cloud(milk).points, wanted);
  ASSERT_GT(left.positions.size(), 500u);

  const Outcome outcome =
      pcd_to_mesh({milk, folder / "mesh.ply", "--voxel=0.006", "--crop", "-1,-1,0.5,1,1,2", "--sor", "16,2",
                   "--report", folder / "report.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  expect_surface_through(io::read_mesh(folder / "mesh.ply"), left);
  const Json report = read_json(folder / "report.json");
  EXPECT_EQ(report.at("read").get<std::size_t>(), 13704u);
  EXPECT_EQ(report.at("points").get<std::size_t>(), left.positions.size());
  EXPECT_NE(outcome.out.find(std::to_string(left.positions.size()) + " after crop, sor, voxel"),
            std::string::npos)
      << outcome.out;

  expect_failure({milk, folder / "no.ply", "--voxel", "1e-7"}, folder, 1);
  expect_failure({milk, folder / "no.ply", "--crop", "8,8,8,9,9,9"}, folder, 1);
}

TEST(PcdToMesh, AViewpointIsThatOfAPcdFileOrGiven) {
  const ScratchFolder folder;
  const std::string milk = TEST_DATA "/milk.pcd";
  Model bare = io::read_cloud(milk);
  ASSERT_TRUE(bare.viewpoint);
  io::write_mesh(folder / "milk.ply", bare);
  const auto mesh = [&](std::vector<std::string> words) {
    words.insert(words.begin() + 1, folder / "mesh.ply");
    words.insert(words.end(), {"--open", "--voxel", "0.004"});
    const Outcome outcome = pcd_to_mesh(words);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return Model(io::read_mesh(folder / "mesh.ply")).triangles;
  };
  EXPECT_EQ(mesh({folder / "milk.ply", "--viewpoint", "0,0,0"}), mesh({milk}));
  EXPECT_NE(mesh({folder / "milk.ply"}), mesh({milk}));
  EXPECT_EQ(mesh({milk, "--viewpoint=9,9,9"}), mesh({folder / "milk.ply"}));
  for (const char* wrong : {"1,2", "1,2,3,4", "x", "1,2,nan", ""})
    expect_failure({milk, folder / "no.ply", "--viewpoint", wrong}, folder, 2);
}

TEST(PcdToMesh, AnOpenScanKeepsItsBorder) {
  const ScratchFolder folder;
  const std::string milk = TEST_DATA "/milk.pcd";
  const Outcome outcome = pcd_to_mesh(
      {milk, folder / "mesh.ply", "--open", "--voxel", "0.004", "--report", folder / "report.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("closed  no, "), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find(", manifold"), std::string::npos) << outcome.out;
  const Json report = read_json(folder / "report.json");
  EXPECT_FALSE(report.at("closed").get<bool>());
  EXPECT_GT(report.at("boundary_loops").get<int>(), 0);
  // Edges of one face only, counted anew.
  std::map<std::pair<int, int>, int> faces_of;
  for (const Triangle& t : Model(io::read_mesh(folder / "mesh.ply")).triangles)
    for (int k = 0; k < 3; ++k) ++faces_of[std::minmax(t[k], t[(k + 1) % 3])];
  int open = 0;
  for (const auto& [edge, faces] : faces_of) {
    EXPECT_LE(faces, 2);
    open += faces == 1 ? 1 : 0;
  }
  EXPECT_EQ(report.at("boundary_edges").get<int>(), open);
}

TEST(PcdToMesh, OutliersAreLeftOffUnlessKept) {
  const ScratchFolder folder;
  Model cloud = io::read_cloud(kSpot);
  cloud.positions.resize(3000);
  const Point stray{9, 9, 9};
  cloud.positions.push_back(stray);
  io::write_mesh(folder / "cloud.ply", cloud);
  const Outcome outcome = pcd_to_mesh({folder / "cloud.ply", folder / "mesh.ply"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("1 outlier left out"), std::string::npos) << outcome.out;
  const Model mesh = io::read_mesh(folder / "mesh.ply");
  EXPECT_EQ(std::count(mesh.positions.begin(), mesh.positions.end(), stray), 0);
  const Outcome kept = pcd_to_mesh({folder / "cloud.ply", folder / "kept.ply", "--keep-outliers"});
  EXPECT_EQ(kept.status, 0) << kept.err;
  EXPECT_EQ(kept.out.find("outlier"), std::string::npos) << kept.out;
}

TEST(PcdToMesh, ABatchIsTheMeshesOneByOne) {
  const ScratchFolder folder;
  std::ofstream(folder / "flat.xyz") << "0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 1 0\n";
  const std::string lamppost = TEST_DATA "/lamppost.pcd";
  const Outcome outcome =
      pcd_to_mesh({folder / "flat.xyz", kBunny, folder / "missing.pcd", lamppost, folder / "new/meshes/",
                   "--jobs", "2", "--to", "obj", "--report", folder / "report.json"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 2) << outcome.err;
  EXPECT_NE(outcome.err.find("flat.xyz: "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("missing.pcd: "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.out.find("2 of 4 meshes"), std::string::npos) << outcome.out;
  for (const auto& [name, cloud] : {std::pair{"bun0.obj", kBunny}, {"lamppost.obj", lamppost}}) {
    ASSERT_EQ(pcd_to_mesh({cloud, folder / "alone.obj"}).status, 0);
    EXPECT_TRUE(io::read_file((folder / "new/meshes/") + name) == io::read_file(folder / "alone.obj"))
        << name;
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder / "new/meshes"), fs::directory_iterator()), 2);
  const Json report = read_json(folder / "report.json");
  ASSERT_EQ(report.size(), 3u);  // the missing one was not tried
  EXPECT_EQ(report.front().at("status").get<std::string>(), "Coplanar");
}

TEST(PcdToMesh, AFolderThatIsThereTakesMeshes) {
  const ScratchFolder folder;
  EXPECT_EQ(pcd_to_mesh({kBunny, folder.path().string()}).status, 0);
  EXPECT_EQ(pcd_to_mesh({"--out-dir", folder.path().string(), TEST_DATA "/bun4.pcd"}).status, 0);
  EXPECT_TRUE(fs::exists(folder / "bun0.ply"));
  EXPECT_TRUE(fs::exists(folder / "bun4.ply"));
  EXPECT_EQ(pcd_to_mesh({kBunny, folder / "bun0.ply/"}).status, 1);  // a file is in the way
}

TEST(PcdToMesh, StandardInputAndOutput) {
  const ScratchFolder folder;
  const Model cloud = io::read_cloud(kBunny);
  io::write_mesh(folder / "cloud.ply", cloud);
  pcl::PCDWriter().writeBinary(folder / "cloud.pcd", io::make_cloud(cloud.positions));
  ASSERT_EQ(pcd_to_mesh({folder / "cloud.ply", folder / "expected.ply"}).status, 0);
  const std::string expected = io::read_file(folder / "expected.ply");
  io::write_mesh(folder / "cloud.obj", cloud);
  std::ofstream text(folder / "cloud.xyz");
  text.precision(17);
  for (const Point& p : cloud.positions) text << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  text.close();
  const auto through_shell = [&](const std::string& file, const std::string& options) {
    return run_program({"/bin/sh", "-c", PCD_TO_MESH " - - " + options + " < " + file});
  };
  for (const char* name : {"cloud.pcd", "cloud.ply", "cloud.obj", "cloud.xyz"}) {
    const std::string file = folder / name;
    const Outcome outcome = through_shell(file, "");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_TRUE(outcome.out == expected) << file;
    EXPECT_NE(outcome.err.find("closed  yes"), std::string::npos) << outcome.err;
  }
  EXPECT_TRUE(through_shell(folder / "cloud.xyz", "--format txt").out == expected);
  const Outcome obj = through_shell(kBunny, "--to obj");
  io::write_file(folder / "piped.obj", obj.out);
  EXPECT_EQ(Model(io::read_mesh(folder / "piped.obj")).triangles,
            Model(io::read_mesh(folder / "expected.ply")).triangles);

  std::ofstream(folder / "noise") << "what is this";
  for (const std::string& file : {std::string("/dev/null"), folder / "noise"}) {
    const Outcome outcome = through_shell(file, "");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
  EXPECT_EQ(run_program({"/bin/sh", "-c", PCD_TO_MESH " " + kBunny + " - > /dev/full"}).status, 1);
}

TEST(PcdToMesh, AFilePastTheSizeLimitIsSaidAndNothingIsLeft) {
  const ScratchFolder folder;
  const Outcome outcome = run_program(
      {"/bin/sh", "-c", "ulimit -f 1; exec " PCD_TO_MESH " " + kBunny + " " + (folder / "mesh.ply")});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("it cannot be written"), std::string::npos) << outcome.err;
  EXPECT_EQ(folder.count(), 0u);
}

TEST(PcdToMesh, ColoursAreInGltfAsAnotherReaderSeesIt) {
  const ScratchFolder folder;
  Model cloud = io::read_cloud(kSpot);
  cloud.positions.resize(3000);
  for (std::size_t i = 0; i < cloud.positions.size(); ++i)
    cloud.colours.push_back({static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i / 20), 77});
  io::write_mesh(folder / "cloud.ply", cloud);
  ASSERT_EQ(pcd_to_mesh({folder / "cloud.ply", folder / "mesh.ply"}).status, 0);
  ASSERT_EQ(pcd_to_mesh({folder / "cloud.ply", folder / "mesh.glb"}).status, 0);
  const Model expected = io::read_mesh(folder / "mesh.ply");

  vtkNew<vtkGLTFReader> reader;
  reader->SetFileName((folder / "mesh.glb").c_str());
  reader->Update();
  const auto blocks = vtkSmartPointer<vtkDataObjectTreeIterator>::New();
  blocks->SetDataSet(reader->GetOutput());
  blocks->VisitOnlyLeavesOn();
  blocks->InitTraversal();
  ASSERT_FALSE(blocks->IsDoneWithTraversal());
  auto* const mesh = vtkPolyData::SafeDownCast(blocks->GetCurrentDataObject());
  ASSERT_NE(mesh, nullptr);
  ASSERT_EQ(mesh->GetNumberOfPoints(), static_cast<vtkIdType>(expected.positions.size()));
  ASSERT_EQ(mesh->GetNumberOfCells(), static_cast<vtkIdType>(expected.triangles.size()));
  for (std::size_t t = 0; t < expected.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(mesh->GetCell(static_cast<vtkIdType>(t))->GetPointId(k), expected.triangles[t][k]);
  vtkDataArray* const colours = mesh->GetPointData()->GetArray("COLOR_0");
  ASSERT_NE(colours, nullptr);
  for (vtkIdType k = 0; k < mesh->GetNumberOfPoints(); ++k) {
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_EQ(mesh->GetPoint(k)[axis], expected.positions[k][axis]);
      const double light = colours->GetComponent(k, axis);  // back to sRGB, as the eye has it
      const double share = light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
      ASSERT_EQ(std::lround(255 * share), expected.colours[k][axis]);
    }
  }
}

TEST(PcdToMesh, GltfOfLargeCoordinatesKeepsTheShape) {
  const ScratchFolder folder;
  Model cloud = io::read_cloud(kBunny);
  for (Point& p : cloud.positions) p = {p[0] + 500000.1, p[1] + 4649776.7, p[2] + 123.4};
  io::write_mesh(folder / "cloud.ply", cloud);
  ASSERT_EQ(pcd_to_mesh({folder / "cloud.ply", folder / "mesh.ply"}).status, 0);
  ASSERT_EQ(pcd_to_mesh({folder / "cloud.ply", folder / "mesh.glb"}).status, 0);
  const Model expected = io::read_mesh(folder / "mesh.ply");

  // A binary glTF is a header of 12 bytes, then JSON and the buffer, each after its length and kind.
  const std::string bytes = io::read_file(folder / "mesh.glb");
  std::uint32_t json_size = 0;
  std::memcpy(&json_size, bytes.data() + 12, sizeof json_size);
  const Json json = Json::parse(bytes.substr(20, json_size));
  Point moved{};
  int axis = 0;
  for (const Json& value : json.at("nodes").front().at("translation")) moved[axis++] = value.get<double>();
  const char* buffer = bytes.data() + 20 + json_size + 8;
  for (const Point& p : expected.positions)
    for (axis = 0; axis < 3; ++axis) {
      float x = 0;
      std::memcpy(&x, buffer, sizeof x);
      buffer += sizeof x;
      ASSERT_NEAR(moved[axis] + x, p[axis], 1e-8);
    }
}

TEST(PcdToMesh, AFailedRunKeepsTheOldMeshAndReports) {
  const ScratchFolder folder;
  std::ofstream(folder / "flat.xyz") << "0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 1 0\n";
  std::ofstream(folder / "mesh.ply") << "an old mesh";
  const Outcome outcome =
      pcd_to_mesh({folder / "flat.xyz", folder / "mesh.ply", "--report", folder / "report.json"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(io::read_file(folder / "mesh.ply"), "an old mesh");
  const Json report = read_json(folder / "report.json");
  EXPECT_EQ(report.at("status").get<std::string>(), "Coplanar");
  EXPECT_NE(report.at("message").get<std::string>(), "");
  EXPECT_EQ(report.at("triangles").get<int>(), 0);
}

TEST(PcdToMesh, InterruptionEndsItCleanly) {
  // Enough noisy points to be busy for long after the first film step.
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  Model cloud;
  for (int i = 0; i < 60000; ++i) {
    Point p{normal(random), normal(random), normal(random)};
    const double scale = (1 + 0.02 * normal(random)) / std::hypot(p[0], p[1], p[2]);
    for (double& x : p) x *= scale;
    cloud.positions.push_back(p);
  }
  const ScratchFolder folder;
  io::write_mesh(folder / "cloud.ply", cloud);
  const fs::path steps = folder / "steps";
  const Outcome outcome = pcd_to_mesh(
      {folder / "cloud.ply", folder / "mesh.ply", "--dump-steps", steps.string()}, [&](pid_t program) {
        const auto has_begun = [&] { return fs::is_directory(steps) && !fs::is_empty(steps); };
        for (int i = 0; i < 6000 && !has_begun(); ++i)
          std::this_thread::sleep_for(std::chrono::milliseconds(10));
        kill(program, SIGINT);
      });
  EXPECT_EQ(outcome.status, 130) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_FALSE(fs::exists(folder / "mesh.ply"));
  EXPECT_EQ(folder.count(), 2u);  // the cloud and the steps
}

}  // namespace
}  // namespace filmsticking::test
