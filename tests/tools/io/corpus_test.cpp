// SPDX-License-Identifier: GPL-3.0-or-later
// One ellipsoid in every variant of every format, as tests/data/formats/make_corpus.py writes it: each is
// read right, or refused with a sentence that says why.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <sstream>

#include "io/files.h"
#include "io/formats.h"
#include "io/io_error.h"
#include "support/model.h"
#include "support/scratch_folder.h"

namespace filmsticking::test {
namespace {

using io::IoError;

struct Variant {
  std::string kind, name;
  std::map<std::string, std::string> facts;

  std::string fact(const std::string& key, const std::string& otherwise) const {
    const auto found = facts.find(key);
    return found == facts.end() ? otherwise : found->second;
  }
};

std::vector<std::string> parts_of(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

class Corpus : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<ScratchFolder>();
    const std::string command =
        "python3 '" TEST_DATA "/formats/make_corpus.py' '" + folder_->path().string() + "'";
    ASSERT_EQ(std::system(command.c_str()), 0);
    std::ifstream manifest(*folder_ / "manifest.tsv"), truth(*folder_ / "truth.txt");
    for (std::string line; std::getline(manifest, line);) {
      const std::vector<std::string> parts = parts_of(line, '\t');
      Variant variant{parts[0], parts[1], {}};
      for (std::size_t k = 2; k < parts.size(); ++k)
        variant.facts[parts[k].substr(0, parts[k].find('='))] = parts[k].substr(parts[k].find('=') + 1);
      variants_.push_back(variant);
    }
    for (std::string line; std::getline(truth, line);) {
      std::istringstream words(line);
      Point p{};
      int colour[3] = {};
      words >> p[0] >> p[1] >> p[2] >> colour[0] >> colour[1] >> colour[2];
      truth_.positions.push_back(p);
      truth_.colours.push_back({static_cast<std::uint8_t>(colour[0]), static_cast<std::uint8_t>(colour[1]),
                                static_cast<std::uint8_t>(colour[2])});
    }
    ASSERT_EQ(truth_.positions.size(), 600u);
  }
  static void TearDownTestSuite() { folder_.reset(); }

  static std::string path(const Variant& variant) { return *folder_ / variant.name; }

  static io::ReadOptions options(const Variant& variant) {
    io::ReadOptions options;
    options.columns = parts_of(variant.fact("columns", ""), ',');
    return options;
  }

  static std::unique_ptr<ScratchFolder> folder_;
  static std::vector<Variant> variants_;
  static Model truth_;
};

std::unique_ptr<ScratchFolder> Corpus::folder_;
std::vector<Variant> Corpus::variants_;
Model Corpus::truth_;

/// What differs from the truth; empty if nothing does.
std::string difference(const Variant& variant, const io::Cloud& cloud, const Model& truth) {
  const Model model = cloud.points;
  const double scale = std::stod(variant.fact("scale", "1")),
               tolerance = std::stod(variant.fact("tolerance", "2e-6"));
  Point offset{};
  const std::vector<std::string> offsets = parts_of(variant.fact("offset", "0,0,0"), ',');
  for (std::size_t k = 0; k < 3; ++k) offset[k] = std::stod(offsets[k]);
  const bool coloured = variant.fact("colours", "0") == "1";
  if (coloured == model.colours.empty()) return coloured ? "no colours" : "colours that are none";
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < model.positions.size(); ++i)
    if (std::all_of(model.positions[i].begin(), model.positions[i].end(),
                    [](double x) { return std::isfinite(x) && std::abs(x) < 1e30; }))
      kept.push_back(i);
  const std::size_t skipped = std::stoul(variant.fact("skipped", "0"));
  if (model.positions.size() - kept.size() != skipped && model.positions.size() != truth.positions.size())
    return std::to_string(model.positions.size() - kept.size()) + " points are not finite";
  if (variant.fact("order", "1") == "0") {
    for (const std::size_t i : kept) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const Point& p : truth.positions) {
        Point away{};
        for (std::size_t k = 0; k < 3; ++k) away[k] = p[k] * scale + offset[k] - model.positions[i][k];
        nearest = std::min(nearest, std::hypot(away[0], away[1], away[2]));
      }
      if (nearest > tolerance) return "a point is elsewhere";
    }
    return kept.size() < 590 ? "points are missing" : "";
  }
  const bool hole = model.positions.size() == truth.positions.size() && skipped > 0;
  if (kept.size() + (hole ? skipped : 0) != truth.positions.size())
    return std::to_string(kept.size()) + " points";
  for (const std::size_t i : kept) {
    for (std::size_t k = 0; k < 3; ++k)
      if (std::abs(model.positions[i][k] - (truth.positions[i][k] * scale + offset[k])) > tolerance)
        return "point " + std::to_string(i) + " is elsewhere";
    for (std::size_t k = 0; k < 3 && coloured; ++k)
      if (std::abs(model.colours[i][k] - truth.colours[i][k]) > 1)
        return "point " + std::to_string(i) + " has another colour";
  }
  return "";
}

std::string joined(const std::vector<std::string>& notes) {
  std::string text;
  for (const std::string& note : notes) text += note + "; ";
  return text;
}

TEST_F(Corpus, EveryVariantIsReadRightOrRefusedWithASentence) {
  EXPECT_GE(variants_.size(), 400u);
  for (const Variant& variant : variants_) {
    SCOPED_TRACE(variant.name + " " + variant.fact("writer", ""));
    std::string refusal;
    io::Cloud cloud;
    try {
      cloud = io::read_cloud(path(variant), options(variant));
    } catch (const IoError& error) {
      refusal = error.what();
    }
    const std::string said = variant.fact("said", "");
    if (variant.kind == "refuse") {
      EXPECT_GT(refusal.size(), 10u) << "was read";
      EXPECT_NE(refusal.find(said), std::string::npos) << refusal;
      continue;
    }
    EXPECT_EQ(refusal, "");
    if (!refusal.empty() || variant.kind == "grid") continue;
    EXPECT_EQ(difference(variant, cloud, truth_), "");
    EXPECT_NE(joined(cloud.notes).find(said), std::string::npos) << joined(cloud.notes);
    for (const std::string& field : parts_of(variant.fact("fields", ""), ','))
      EXPECT_TRUE(io::find_field(cloud.points, field.c_str())) << field;
  }
}

TEST_F(Corpus, AGridHasTheCentresOfItsCells) {
  int grids = 0;
  for (const Variant& variant : variants_) {
    if (variant.kind != "grid") continue;
    ++grids;
    const io::Cloud cloud = io::read_cloud(path(variant));
    const std::vector<Point> points = io::positions_of(cloud.points);
    ASSERT_EQ(points.size(), 11u) << variant.name;
    EXPECT_EQ(points[0], (Point{101, 205, 10}));
    EXPECT_EQ(points[10], (Point{107, 201, 13.5}));
    EXPECT_NE(joined(cloud.notes).find("left out 1 of"), std::string::npos);
  }
  EXPECT_EQ(grids, 2);
}

TEST_F(Corpus, WhatIsCutOffIsRefusedOrThePointsUpToThere) {
  for (const Variant& variant : variants_) {
    if (variant.kind != "read") continue;
    SCOPED_TRACE(variant.name);
    const std::string whole = io::read_file(path(variant));
    std::vector<Point> all;
    for (const Point& p :
         io::positions_of(io::decode_any(whole, io::extension_of(variant.name), options(variant)).points))
      if (std::isfinite(p[0])) all.push_back(p);
    std::sort(all.begin(), all.end());
    for (const double share : {0.02, 0.3, 0.61, 0.9, 0.98}) {
      const auto size = static_cast<std::size_t>(share * static_cast<double>(whole.size()));
      try {
        const io::Cloud cloud = io::decode_any(std::string_view(whole).substr(0, size),
                                               io::extension_of(variant.name), options(variant));
        std::size_t strange = 0;
        for (const Point& p : io::positions_of(cloud.points))
          strange += std::isfinite(p[0]) && !std::binary_search(all.begin(), all.end(), p) ? 1 : 0;
        EXPECT_LE(strange, 1u) << share;  // a number may be cut
      } catch (const IoError&) {
      }
    }
  }
}

TEST_F(Corpus, CorruptFilesNeitherCrashNorGiveMorePointsThanBytes) {
  std::mt19937 random(7);
  for (const Variant& variant : variants_)
    for (int run = 0; run < 5; ++run) {
      std::string bytes = io::read_file(path(variant));
      for (int k = 0; k < 1 + 3 * run; ++k) {
        const std::size_t most = k % 2 == 0 ? std::min<std::size_t>(bytes.size(), 400) : bytes.size();
        bytes[random() % most] = static_cast<char>(random());
      }
      try {
        const io::Cloud cloud = io::decode_any(bytes, io::extension_of(variant.name), options(variant));
        EXPECT_LE(io::size_of(cloud.points), bytes.size()) << variant.name;
      } catch (const IoError&) {
      }
    }
}

TEST_F(Corpus, EveryFormatIsWrittenInItsManyVariants) {
  std::map<std::string, int> count;
  for (const Variant& variant : variants_) ++count[io::extension_of(variant.name)];
  for (const char* extension : {".xyz", ".txt", ".csv", ".asc", ".pts", ".ptx", ".pcd", ".ply", ".las",
                                ".off", ".obj", ".vtk", ".stl"})
    EXPECT_GE(count[extension], 4) << extension;
}

}  // namespace
}  // namespace filmsticking::test
