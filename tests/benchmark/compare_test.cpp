// SPDX-License-Identifier: GPL-3.0-or-later
// compare as a user runs it, on small clouds.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "compare/csv.h"
#include "compare/normals.h"
#include "io/formats.h"
#include "support/run_program.h"
#include "support/scratch_folder.h"

namespace filmsticking::bench {
namespace {

using test::Outcome;
using test::ScratchFolder;
using Fields = std::map<std::string, std::string>;  // a row of the CSV by column

Outcome compare(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), COMPARE);
  return test::run_program(arguments);
}

std::string read_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), {});
}

void write_text(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

std::vector<Fields> read_rows(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> header = csv_fields(line);
  std::vector<Fields> rows;
  while (std::getline(file, line)) {
    const std::vector<std::string> fields = csv_fields(line);
    EXPECT_EQ(fields.size(), header.size()) << line;
    rows.emplace_back();
    for (std::size_t i = 0; i < std::min(fields.size(), header.size()); ++i)
      rows.back()[header[i]] = fields[i];
  }
  return rows;
}

Fields find_row(const std::vector<Fields>& rows, const std::string& shape, const std::string& method) {
  for (const Fields& row : rows)
    if (row.at("shape") == shape && row.at("method") == method) return row;
  ADD_FAILURE() << "no row of " << method << " on " << shape;
  return {};
}

double number(const Fields& row, const std::string& column) {
  const auto found = row.find(column);
  if (found == row.end() || found->second.empty()) {
    ADD_FAILURE() << "no " << column;
    return -1;
  }
  return std::strtod(found->second.c_str(), nullptr);
}

TEST(Compare, NormalsOfASphereAllHaveTheRightSign) {
  const ScratchFolder folder;
  const Outcome outcome = compare(
      {"normals", "sphere", "--points", "1K", "--csv", folder / "out.csv", "--markdown", folder / "out.md"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<Fields> rows = read_rows(folder / "out.csv");
  for (const char* method : {"ours", "cgal-mst", "pcl-centroid"}) {
    const Fields row = find_row(rows, "sphere", method);
    EXPECT_EQ(number(row, "right"), 1);
    EXPECT_LT(number(row, "angle"), 15);
  }
  EXPECT_NE(read_text(folder / "out.md").find("100.0 %"), std::string::npos);
}

TEST(Normals, SignsAreCountedWhereTheTruthIsKnown) {
  const std::vector<Sample> samples = {{Vec3(0, 0, 0), Vec3(0, 0, 1)},
                                       {Vec3(0, 0, 0), Vec3(1, 0, 0)},
                                       {Vec3(0, 0, 0), Vec3(0, 0, 0)}};  // an outlier
  EXPECT_EQ(right_signs({{0, 0.9, 0.1}, {-1, 0, 0}, {1, 0, 0}}, samples), 0.5);
}

TEST(Compare, TwoModelsThreeMethods) {
  const ScratchFolder folder;
  const Outcome outcome = compare({"quality", "sphere", "torus", "--points", "1K", "--methods",
                                   "ours,cgal-advancing-front,cgal-alpha-wrap", "--csv", folder / "out.csv",
                                   "--markdown", folder / "out.md"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<Fields> rows = read_rows(folder / "out.csv");
  ASSERT_EQ(rows.size(), 6U);
  for (const Fields& row : rows) {
    EXPECT_EQ(row.at("status"), "ok") << row.at("message");
    EXPECT_EQ(row.at("timing"), "fit");
    EXPECT_EQ(row.at("closed"), "true");
    EXPECT_EQ(number(row, "self_intersections"), 0);
    EXPECT_GT(number(row, "seconds"), 0);
    EXPECT_GE(number(row, "seconds_with_needs"), number(row, "seconds"));
    EXPECT_GT(number(row, "cpu_seconds"), 0);
    EXPECT_GT(number(row, "memory_mb"), 1);
    EXPECT_LT(number(row, "memory_mb"), 2000);
    // 1,000 points on surfaces of 10 units: the chord's height is some thousandths of the box.
    EXPECT_GT(number(row, "chamfer_e3"), 0.1);
    EXPECT_LT(number(row, "chamfer_e3"), 20);
    EXPECT_GT(number(row, "normal_consistency"), 90);
  }
  for (const char* shape : {"sphere", "torus"}) {
    const Fields ours = find_row(rows, shape, "ours");
    EXPECT_EQ(ours.at("manifold"), "true");
    EXPECT_EQ(ours.at("oriented"), "true");
    EXPECT_EQ(ours.at("outward"), "true");
    EXPECT_EQ(ours.at("topology_right"), "true");
    EXPECT_EQ(number(ours, "genus"), shape == std::string("torus") ? 1 : 0);
    EXPECT_EQ(number(ours, "interpolated"), 100);
    EXPECT_EQ(number(ours, "vertices"), 1000);
    EXPECT_NE(ours.at("rooms").find('='), std::string::npos);
    EXPECT_EQ(number(find_row(rows, shape, "cgal-alpha-wrap"), "interpolated"), 0);
  }
  const std::string tables = read_text(folder / "out.md");
  EXPECT_NE(tables.find("### monte-carlo, 1000 points"), std::string::npos);
  EXPECT_NE(tables.find("| ours | 2 of 2 | 100 | 100 | 100 | 100.00 |"), std::string::npos) << tables;
}

TEST(Compare, WhatGoesWrongIsARowThatSaysSo) {
  const ScratchFolder folder;
  const Outcome outcome =
      compare({"quality", "sphere", "--points", "200", "--methods",
               "fault-crash,fault-hang,fault-throw,fault-memory,ours", "--time-limit", "5", "--memory-limit",
               "1000", "--threads", "1", "--csv", folder / "out.csv"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<Fields> rows = read_rows(folder / "out.csv");
  ASSERT_EQ(rows.size(), 5U);
  EXPECT_EQ(find_row(rows, "sphere", "fault-crash").at("status"), "crashed");
  EXPECT_EQ(find_row(rows, "sphere", "fault-hang").at("status"), "time limit");
  EXPECT_EQ(find_row(rows, "sphere", "fault-throw").at("status"), "failed");
  EXPECT_NE(find_row(rows, "sphere", "fault-throw").at("message").find("thrown, on purpose"),
            std::string::npos);
  EXPECT_EQ(find_row(rows, "sphere", "fault-memory").at("status"), "out of memory");
  EXPECT_EQ(find_row(rows, "sphere", "ours").at("status"), "ok");
  EXPECT_NE(outcome.out.find("fault-hang on sphere, monte-carlo, 200 points, seed 1: time limit"),
            std::string::npos);
}

TEST(Compare, GoesOnWhereItWasStopped) {
  const ScratchFolder folder;
  const std::vector<std::string> command = {"quality", "sphere",          "--points",
                                            "200",     "--methods",       "ours,cgal-advancing-front",
                                            "--csv",   folder / "out.csv"};
  ASSERT_EQ(compare(command).status, 0);
  std::string text = read_text(folder / "out.csv");
  // The first row is marked, to see that it is not made anew; the second one was cut off while it was
  // written.
  const std::size_t at = text.find(",ok,,");
  ASSERT_NE(at, std::string::npos);
  text.replace(at, 5, ",ok,marked,");
  write_text(folder / "out.csv", text.substr(0, text.size() - 20));
  ASSERT_EQ(compare(command).status, 0);
  std::vector<Fields> rows = read_rows(folder / "out.csv");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].at("message"), "marked");
  EXPECT_EQ(rows[1].at("method"), "cgal-advancing-front");
  EXPECT_EQ(rows[1].at("message"), "");

  std::vector<std::string> fresh = command;
  fresh.push_back("--fresh");
  ASSERT_EQ(compare(fresh).status, 0);
  rows = read_rows(folder / "out.csv");
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].at("message"), "");

  write_text(folder / "out.csv", "something,else\n1,2\n");
  EXPECT_EQ(compare(command).status, 1);
  EXPECT_EQ(read_text(folder / "out.csv"), "something,else\n1,2\n");
}

TEST(Compare, SeveralCloudsAtOnceAreTheSameButForTheTime) {
  const ScratchFolder folder;
  const auto run = [&](const std::string& jobs, const std::string& csv) {
    return compare({"quality", "sphere", "torus", "--points", "300,200", "--seeds", "1,2", "--methods",
                    "cgal-advancing-front", "--jobs", jobs, "--csv", csv})
        .status;
  };
  ASSERT_EQ(run("1", folder / "one.csv"), 0);
  ASSERT_EQ(run("3", folder / "three.csv"), 0);
  const std::vector<Fields> one = read_rows(folder / "one.csv");
  ASSERT_EQ(one.size(), 8U);
  std::map<std::string, std::string> chamfer;
  const auto key = [](const Fields& row) {
    return row.at("shape") + row.at("points") + "/" + row.at("seed");
  };
  for (const Fields& row : one) chamfer[key(row)] = row.at("chamfer_e3");
  ASSERT_EQ(chamfer.size(), 8U);
  for (const Fields& row : read_rows(folder / "three.csv")) {
    EXPECT_EQ(row.at("chamfer_e3"), chamfer[key(row)]) << key(row);
    EXPECT_EQ(row.at("timing"), "unfit");
  }
}

TEST(Compare, TakesListsAndClouds) {
  const ScratchFolder folder;
  write_text(folder / "list.tsv", "name\tfile\tuse\na\tsphere\tyes\nb\tno_such_file.ply\tno\n");
  const Outcome outcome =
      compare({"quality", TEST_DATA "/bun0.pcd", "--list", folder / "list.tsv", "--where", "use=yes",
               "--points", "200", "--methods", "cgal-advancing-front", "--csv", folder / "out.csv"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<Fields> rows = read_rows(folder / "out.csv");
  ASSERT_EQ(rows.size(), 2U);
  const Fields bunny = find_row(rows, "bun0", "cgal-advancing-front");
  EXPECT_EQ(bunny.at("kind"), "as it is");
  EXPECT_EQ(bunny.at("points"), "397");
  EXPECT_EQ(bunny.at("chamfer_e3"), "");  // there is no truth
  EXPECT_GT(number(bunny, "interpolated"), 90);
  EXPECT_EQ(number(find_row(rows, "sphere", "cgal-advancing-front"), "points"), 200);
}

TEST(Compare, Speed) {
  const ScratchFolder folder;
  const Outcome outcome = compare({"speed", "sphere", "--points", "500,2000", "--runs", "2", "--csv",
                                   folder / "out.csv", "--markdown", folder / "out.md"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<Fields> rows = read_rows(folder / "out.csv");
  // Sizes x runs x (ours on all threads, ours on one, Delaunay, advancing front).
  ASSERT_EQ(rows.size(), 2U * 2 * 4);
  for (const Fields& row : rows) {
    EXPECT_EQ(row.at("status"), "ok");
    EXPECT_GT(number(row, "seconds"), 0);
  }
  const std::string tables = read_text(folder / "out.md");
  for (const char* part :
       {"| ours, all threads |", "| ours, 1 thread |", "exponent of growth", "Stages of ours"})
    EXPECT_NE(tables.find(part), std::string::npos) << part;
}

TEST(Compare, SampleWritesTheCloud) {
  const ScratchFolder folder;
  for (const char* name : {"a.ply", "b.ply"})
    ASSERT_EQ(
        compare({"sample", "torus", "--points", "1K", "--sampling", "poisson-disk", "-o", folder / name})
            .status,
        0);
  EXPECT_EQ(read_text(folder / "a.ply"), read_text(folder / "b.ply"));
  EXPECT_EQ(io::size_of(io::read_cloud(folder / "a.ply").points), 1000U);
}

TEST(Compare, Scans) {
  const ScratchFolder folder;
  const Outcome outcome =
      compare({"scans", "--kinds", "corners,volume", "--seeds", "1,2", "--methods", "cgal-advancing-front",
               "--csv", folder / "out.csv", "--markdown", folder / "out.md"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<Fields> rows = read_rows(folder / "out.csv");
  ASSERT_EQ(rows.size(), 4U);
  for (const Fields& row : rows) {
    EXPECT_EQ(row.at("status"), "ok") << row.at("message");
    EXPECT_GT(number(row, "seconds"), 0);
    EXPECT_GT(number(row, "longest_edge"), 0);
  }
  EXPECT_EQ(number(rows[0], "needed_used"), 8);
  EXPECT_EQ(rows[2].at("wrong"), "no warning");  // that method knows none
  EXPECT_NE(read_text(folder / "out.md").find("| volume | 0 of 2 |"), std::string::npos);
}

TEST(Compare, ScansWithSensors) {
  const ScratchFolder folder;
  const Outcome outcome =
      compare({"scans", "--kinds", "cliffs", "--seeds", "1", "--csv", folder / "out.csv"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<Fields> rows = read_rows(folder / "out.csv");
  ASSERT_EQ(rows.size(), 2U);
  for (const Fields& row : rows) EXPECT_EQ(row.at("status"), "ok") << row.at("message");
  EXPECT_EQ(rows[1].at("method"), "ours-open-sight");
  EXPECT_GT(number(rows[1], "front"), 0.95);
}

TEST(Compare, MethodsThatNeedSensorsSaySo) {
  const ScratchFolder folder;
  const Outcome outcome = compare(
      {"quality", "sphere", "--points", "200", "--methods", "ours-sight", "--csv", folder / "out.csv"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(read_rows(folder / "out.csv")[0].at("status"), "failed");
  EXPECT_NE(outcome.out.find("seen from"), std::string::npos) << outcome.out;
}

TEST(Compare, Berger) {
  const ScratchFolder folder;
  std::vector<Point> points, cameras;  // of a ball, from all around
  std::string probes;
  for (int i = 0; i < 1000; ++i) {
    const double z = 1 - (2 * i + 1.0) / 1000, r = std::sqrt(1 - z * z), angle = 2.399963 * i;
    points.push_back({r * std::cos(angle), r * std::sin(angle), z});
    cameras.push_back({9 * r * std::cos(angle), 9 * r * std::sin(angle), 9 * z});
  }
  for (int i = 0; i < 4000; ++i) {
    const float p[4] = {static_cast<float>(i % 16) / 5 - 1.5F, static_cast<float>(i / 16 % 16) / 5 - 1.5F,
                        static_cast<float>(i / 256) / 5 - 1.5F, 0};
    const float record[4] = {p[0], p[1], p[2], p[0] * p[0] + p[1] * p[1] + p[2] * p[2] < 1 ? 1.0F : 0.0F};
    probes.append(reinterpret_cast<const char*>(record), sizeof record);
  }
  io::write_mesh(folder / "ball.ply",
                 io::with_named_stations(io::with_stations(io::make_cloud(points), cameras)), {});
  write_text(folder / "ball.occupancy.f32", probes);
  const Outcome outcome =
      compare({"berger", folder / "", "--methods", "ours-sight,cgal-advancing-front,fault-throw", "--csv",
               folder / "out.csv", "--markdown", folder / "out.md"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<Fields> rows = read_rows(folder / "out.csv");
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_GT(number(rows[0], "iou"), 0.95);
  EXPECT_EQ(rows[2].at("iou"), "");
  EXPECT_NE(read_text(folder / "out.md").find("| ball | fault-throw | failed |"), std::string::npos);

  write_text(folder / "ball.occupancy.f32", probes + "x");
  EXPECT_EQ(compare({"berger", folder / ""}).status, 1);
  EXPECT_EQ(compare({"berger", folder / "absent"}).status, 1);
}

TEST(Compare, Sheet) {
  const ScratchFolder folder;
  const Outcome outcome = compare({"sheet", "sphere", TEST_DATA "/bun0.pcd", "--points", "300", "--methods",
                                   "cgal-advancing-front,fault-crash", "-o", folder / "sheet.png"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string png = read_text(folder / "sheet.png");
  ASSERT_GT(png.size(), 1000U);
  const auto big_endian = [&](std::size_t at) {
    int value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(png[at + i]);
    return value;
  };
  EXPECT_EQ(big_endian(16), 3 * big_endian(20) / 2);  // 3 columns, 2 rows of square panels
}

TEST(Compare, WhatMakesNoSenseIsRefusedInASentence) {
  const ScratchFolder folder;
  const std::vector<std::vector<std::string>> wrong = {
      {},
      {"bake", "sphere"},
      {"quality"},
      {"quality", "sphere", "--methods", "magic"},
      {"quality", "sphere", "--points", "0"},
      {"quality", "sphere", "--points", "many"},
      {"quality", "sphere", "--sampling", "perfect"},
      {"quality", "sphere", "--noise", "2"},
      {"sheet", "sphere"},
      {"sample", "sphere", "--points", "1K,2K", "-o", folder / "x.ply"},
      {"quality", "sphere", "--where", "no equals sign"},
      {"quality", "sphere", "--kinds", "tube"},
      {"scans", "sphere"},
      {"berger"},
      {"scans", "--kinds", "magic"}};
  for (const auto& arguments : wrong) {
    const Outcome outcome = compare(arguments);
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_EQ(outcome.err.rfind("compare: ", 0), 0U) << outcome.err;
  }
  for (const std::string& input :
       {folder / "absent.ply", std::string("slab:-1"), std::string(TEST_DATA "/README.md")}) {
    const Outcome outcome =
        compare({"quality", input, "--points", "100", "--methods", "cgal-advancing-front"});
    EXPECT_EQ(outcome.status, 1) << input;
    EXPECT_EQ(outcome.err.rfind("compare: ", 0), 0U) << outcome.err;
  }
  EXPECT_EQ(compare({"--help"}).status, 0);
}

}  // namespace
}  // namespace filmsticking::bench
