// SPDX-License-Identifier: GPL-3.0-or-later
// Files that end too soon, and files with lines and headers out of all proportion.
#include "broken_files.h"

#include <gtest/gtest.h>

#include <chrono>

#include "io/formats.h"
#include "io/io_error.h"
#include "support/model.h"

namespace filmsticking::test {
namespace {

using io::IoError;

/// Whether something in it, after a part of a word, is more than blanks: without that, a text that is cut off
/// looks whole.
bool has_another_word(std::string_view rest) {
  const std::size_t blank = rest.find_first_of(" \r\n");
  return blank != std::string_view::npos && rest.find_first_not_of(" \r\n", blank) != std::string_view::npos;
}

TEST(BrokenFiles, TheSamplesAreWhole) {
  for (const Sample& sample : samples()) {
    SCOPED_TRACE(sample.name);
    EXPECT_EQ(io::detect_format(sample.bytes), sample.extension.substr(1));
    const Model model = io::decode_mesh(sample.extension.substr(1), sample.bytes);
    EXPECT_EQ(model.positions.size(), sample.extension == ".stl" ? 4u : 5u);  // the corners alone
    EXPECT_EQ(model.triangles.size(), sample.extension == ".pcd" ? 0u : 4u);
    EXPECT_EQ(model.colours.size(), sample.extension == ".stl" ? 0u : 5u);
    EXPECT_EQ(io::decode_cloud(sample.extension.substr(1), sample.bytes).points.data,
              io::decode_mesh(sample.extension.substr(1), sample.bytes).cloud.data);
  }
}

TEST(BrokenFiles, WhereverAFileEndsTooSoonItIsRefused) {
  for (const Sample& sample : samples())
    for (std::size_t size = 0; size < sample.bytes.size(); ++size) {
      const bool text = sample.name == "pcd_ascii" || sample.name == "ply_ascii" || sample.name == "stl_text";
      if (text && !has_another_word(std::string_view(sample.bytes).substr(size)) && sample.name != "stl_text")
        continue;
      if (sample.name == "stl_text" && size + 1 == sample.bytes.size()) continue;  // the last line end
      EXPECT_THROW(
          io::decode_cloud(sample.extension.substr(1), std::string_view(sample.bytes).substr(0, size)),
          IoError)
          << sample.name << " to byte " << size;
    }
}

TEST(BrokenFiles, WhatComesBeforeTheEndOfAListOfLinesIsRead) {
  // These formats do not say how long they are.
  const std::string obj = "v 0.5 0 0\nv 1.25 0 0\nv 0 1.5 0\nv 0 0 2.25\nf 1 3 2\nf 1 2 4\n",
                    xyz = "0.5 0 0\n1.25 0 0\n0 1.5 0\n0 0 2.25\n";
  for (const auto& [format, bytes] : {std::pair<std::string, std::string>{"obj", obj}, {"xyz", xyz}}) {
    const Model whole = io::decode_mesh(format, bytes);
    for (std::size_t size = 0; size < bytes.size(); ++size) try {
        const Model part = io::decode_mesh(format, std::string_view(bytes).substr(0, size));
        ASSERT_LE(part.positions.size(), whole.positions.size());
        ASSERT_LE(part.triangles.size(), whole.triangles.size());
        for (std::size_t i = 0; i + 1 < part.positions.size(); ++i)
          EXPECT_EQ(part.positions[i], whole.positions[i]) << format << " to byte " << size;
      } catch (const IoError&) {
      }
  }
}

/// Decodes any bytes. Returns the seconds that it took.
double seconds_for(const std::string& format, const std::string& bytes) {
  const auto begin = std::chrono::steady_clock::now();
  try {
    static_cast<void>(io::detect_format(bytes));
    io::decode_cloud(format, bytes);
  } catch (const IoError&) {
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

TEST(BrokenFiles, LongLinesAndHeadersTakeNoMoreTimeThanTheirLength) {
  const std::string ply = "ply\nformat ascii 1.0\n", pcd = "VERSION 0.7\nFIELDS x y z",
                    points = "WIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA ascii\n0 0 0\n";
  const int n = 300000;
  const std::vector<std::pair<std::string, std::string>> files = {
      {"xyz", std::string(4000000, '1')},
      {"xyz", "0 0 0 " + repeated("7 ", n)},
      {"xyz", repeated("\n", 10 * n)},
      {"xyz", repeated("heading\n", n)},
      {"obj", "v 0 0 0 " + repeated("7 ", n) + "\nf " + repeated("1 ", n)},
      {"obj", "# " + std::string(4000000, 'x')},
      {"stl", "solid " + std::string(4000000, 'x')},
      {"stl", "solid " + repeated("vertex 0 0 0 ", n)},
      {"ply", ply + "comment " + std::string(4000000, 'x')},
      {"ply", ply + repeated("comment\n", n)},
      {"ply", ply + repeated("element vertex 1000000000\n", n) + "end_header\n"},
      {"ply",
       ply + "element vertex 1000000000\n" + repeated("property float x\n", n) + "end_header\n1 2 3\n"},
      {"ply", ply + "element vertex 3\nproperty list uchar float x\n" + repeated("property float y\n", n) +
                  "property float z\nend_header\n" + repeated("1 ", n)},
      {"pcd", pcd + repeated(" f", n) + "\n" + points},
      {"pcd", repeated(pcd + "\n", n / 4) + repeated("SIZE 4\n", n) + points},
      {"pcd", repeated(pcd + "\n", 1000) + repeated("COUNT" + repeated(" 1", 3000) + "\n", 300) + points},
      {"pcd", pcd + "\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1000000000\n" + points},
      {"pcd", "# " + std::string(4000000, 'x')},
  };
  for (std::size_t i = 0; i < files.size(); ++i)  // milliseconds each; a quadratic reader takes minutes
    EXPECT_LT(seconds_for(files[i].first, files[i].second), 20) << "file " << i << ", " << files[i].first;
}

}  // namespace
}  // namespace filmsticking::test
