// SPDX-License-Identifier: GPL-3.0-or-later
#include "stream/strict_pcd.h"

#include <gtest/gtest.h>

#include "io/files.h"
#include "stream/stream_error.h"

namespace filmsticking::stream {
namespace {

TEST(StrictPcd, RefusesWhatPclsReaderDoesNotStand) {
  const std::vector<std::string> lines = {
      "VERSION 0.7", "FIELDS x y z", "SIZE 4 4 4", "TYPE F F F",
      "COUNT 1 1 1", "WIDTH 2",      "HEIGHT 1",   "VIEWPOINT 0 0 0 1 0 0 0",
      "POINTS 2",    "DATA ascii",   "1 2 3",      "4 5 6"};
  const auto file = [](const std::vector<std::string>& of) {
    std::string text = "# .PCD v0.7\n";
    for (const std::string& line : of) text += line + "\n";
    return text;
  };
  EXPECT_NO_THROW(check_pcd(file(lines)));
  for (const char* name : {"bun0", "bun4", "lamppost", "milk", "spot_turntable/scan_00"})
    EXPECT_NO_THROW(check_pcd(io::read_file(std::string(TEST_DATA "/") + name + ".pcd"))) << name;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    std::vector<std::string> without = lines;
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(k));
    if (lines[k].rfind("VIEWPOINT", 0) == 0 || lines[k].rfind("COUNT", 0) == 0) {
      EXPECT_NO_THROW(check_pcd(file(without))) << lines[k];  // these two have defaults
    } else {
      EXPECT_THROW(check_pcd(file(without)), StreamError) << lines[k];
    }
  }
  for (const auto& [line, other] : std::vector<std::pair<std::size_t, std::string>>{
           {1, "FIELDS x y"},
           {2, "SIZE 4 4"},
           {2, "SIZE 4 4 3"},
           {3, "TYPE F F X"},
           {4, "COUNT 1 1 -1"},
           {4, "COUNT 1 1 0"},
           {5, "WIDTH 99999999999999999999"},
           {5, "WIDTH 3"},
           {7, "VIEWPOINT 0 0 0 nan 0 0 0"},
           {9, "DATA binary"},
           {9, "DATA binary_compressed"},
           {9, "DATA"},
           {10, "1 2"},
       }) {
    std::vector<std::string> changed = lines;
    changed[line] = other;
    EXPECT_THROW(check_pcd(file(changed)), StreamError) << other;
  }
  EXPECT_THROW(check_pcd(""), StreamError);
}

TEST(StrictPcd, TheHeaderDoesNotGoOnBehindItsData) {
  const std::string header =
      "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 8\nHEIGHT 1\nPOINTS 8\n"
      "DATA binary\n";
  const auto file = [&](std::string body) { return header + body + std::string(96 - body.size(), '.'); };
  EXPECT_NO_THROW(check_pcd(file("# what looks like a comment\n\n is none\nCOUNT 9 9 9\n")));
  for (const char* body :
       {"COUNT 9 9 9\n", "#\nCOUNT 9 9 9\n", "\n\n \tSIZE 8 8 8\n", "#\r\n\vPOINTS 9000\n"})
    EXPECT_THROW(check_pcd(file(body)), StreamError) << body;
}

TEST(StrictPcd, ABlankLineInTheHeaderIsRefused) {
  const auto file = [](const std::string& between) {
    return "VERSION 0.7\n" + between +
           "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA ascii\n1 2 "
           "3\n";
  };
  EXPECT_NO_THROW(check_pcd(file("\n")));
  for (const char* blank : {"\r\n", " \n", "\t\n", "\n \r\n"})
    EXPECT_THROW(check_pcd(file(blank)), StreamError);
}

}  // namespace
}  // namespace filmsticking::stream
