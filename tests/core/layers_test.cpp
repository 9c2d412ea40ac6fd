// SPDX-License-Identifier: GPL-3.0-or-later
// The layers of the source: an include may lead to the own folder or to one below it, never upward. And every
// source file of the core has its test.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace filmsticking {
namespace {

namespace fs = std::filesystem;
using Sources = std::map<std::string, std::string>;  // text by path from the root of the repository

// From the bottom to the top. Folders of one line do not include each other.
const std::vector<std::vector<std::string>> kLayers = {
    {"include/filmsticking"},
    {"src/core/geometry"},
    {"src/core/points"},
    {"src/core/delaunay"},
    {"src/core/surface"},
    {"src/core/evidence"},
    {"src/core/film"},
    {"src/core/labelling"},
    {"src/core"},
    {"include/pcl/surface"},
    {"src/pcl"},
    {"src/tools/io"},
    {"src/tools/filters"},
    {"src/tools/stream"},
    {"src/tools/report"},
    {"src/tools/scene"},
    {"apps/common"},
    {"apps", "ros", "examples", "benchmark"},
};

// The folders that includes are written from, beside that of the file itself.
const std::vector<std::string> kRoots = {"include", "src/core", "src/tools", "src", "apps", "benchmark", "."};

// Of the deepest folder listed that holds the file; -1: none.
int layer_of(const std::string& path) {
  int layer = -1;
  std::size_t longest = 0;
  for (std::size_t i = 0; i < kLayers.size(); ++i)
    for (const std::string& folder : kLayers[i])
      if (path.rfind(folder + "/", 0) == 0 && folder.size() > longest)
        layer = static_cast<int>(i), longest = folder.size();
  return layer;
}

// The folder of its layer, whose files may include each other.
std::string folder_of(const std::string& path) {
  const int layer = layer_of(path);
  if (layer < 0) return {};
  for (const std::string& folder : kLayers[static_cast<std::size_t>(layer)])
    if (path.rfind(folder + "/", 0) == 0) return folder;
  return {};
}

std::vector<std::string> includes_of(const std::string& text) {
  std::vector<std::string> names;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t hash = line.find_first_not_of(" \t");
    if (hash == std::string::npos || line.compare(hash, 8, "#include") != 0) continue;
    const std::size_t open = line.find_first_of("\"<", hash), close = line.find_first_of("\">", open + 1);
    if (close != std::string::npos) names.push_back(line.substr(open + 1, close - open - 1));
  }
  return names;
}

// The file of the repository that an include means; empty: one of a library.
std::string target_of(const Sources& sources, const std::string& path, const std::string& name) {
  std::vector<std::string> folders = kRoots;
  folders.insert(folders.begin(), fs::path(path).parent_path().generic_string());
  for (const std::string& folder : folders) {
    const std::string target = (fs::path(folder) / name).lexically_normal().generic_string();
    if (sources.count(target) > 0) return target;
  }
  return {};
}

// Includes that lead upward, or from the core to PCL.
std::vector<std::string> faults(const Sources& sources) {
  std::vector<std::string> all;
  for (const auto& [path, text] : sources) {
    const int layer = layer_of(path);
    if (layer < 0) continue;
    for (const std::string& name : includes_of(text)) {
      const std::string target = target_of(sources, path, name);
      const bool core = path.rfind("src/core/", 0) == 0 || path.rfind("include/filmsticking/", 0) == 0;
      const bool upward =
          !target.empty() && layer_of(target) >= layer && folder_of(target) != folder_of(path);
      if (upward || (core && name.rfind("pcl/", 0) == 0)) all.push_back(path + " includes " + name);
    }
  }
  return all;
}

Sources read_sources() {
  Sources sources;
  const fs::path root(SOURCE_ROOT);
  for (const char* folder : {"include", "src", "apps", "ros", "examples", "benchmark"}) {
    if (!fs::exists(root / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const std::string end = entry.path().extension().string();
      if (end != ".h" && end != ".hpp" && end != ".cpp") continue;
      std::ostringstream text;
      text << std::ifstream(entry.path()).rdbuf();
      sources[entry.path().lexically_relative(root).generic_string()] = text.str();
    }
  }
  return sources;
}

TEST(Includes, NoIncludeLeadsUpward) {
  const Sources sources = read_sources();
  EXPECT_GT(sources.size(), 150U);
  std::size_t arrows = 0;
  for (const auto& [path, text] : sources)
    for (const std::string& name : includes_of(text)) arrows += !target_of(sources, path, name).empty();
  EXPECT_GT(arrows, 500U);  // includes are understood
  for (const std::string& fault : faults(sources)) ADD_FAILURE() << fault;
}

TEST(Includes, AnArrowUpwardIsSeen) {
  const Sources fine = {
      {"src/core/geometry/vec.h", "#include <vector>\n"},
      {"src/core/labelling/cut.h", "#include \"geometry/vec.h\"\n#include \"labelling/cut.h\"\n"},
      {"src/core/pipeline.h", "#include \"labelling/cut.h\"\n"},
      {"src/tools/io/files.h", "#include <pcl/PCLPointCloud2.h>\n#include \"new_file.h\"\n"},
      {"src/tools/io/new_file.h", ""},
      {"src/tools/scene/camera.h", "#include \"io/files.h\"\n"},
      {"apps/common/main.h", "#include \"io/files.h\"\n"},
      {"apps/view/main.cpp", "#include \"common/main.h\"\n"},
      {"ros/node.cpp", "#include \"scene/camera.h\"\n"}};
  EXPECT_TRUE(faults(fine).empty());
  const std::pair<const char*, const char*> arrows[] = {
      {"src/core/geometry/vec.h", "#include \"labelling/cut.h\"\n"},
      {"src/core/labelling/cut.h", "  #include \"pipeline.h\"\n"},
      {"src/core/labelling/cut.h", "#include <pcl/point_types.h>\n"},
      {"src/core/labelling/cut.h", "#include \"../pipeline.h\"\n"},
      {"src/tools/io/files.h", "#include \"scene/camera.h\"\n"},
      {"src/tools/io/files.h", "#include \"common/main.h\"\n"},
      {"apps/common/main.h", "#include \"view/main.cpp\"\n"},
      {"ros/node.cpp", "#include \"apps/view/main.cpp\"\n"}};
  for (const auto& [path, include] : arrows) {
    Sources bad = fine;
    bad[path] += include;
    EXPECT_EQ(faults(bad).size(), 1U) << path << ": " << include;
  }
}

// Core files without a test of their name, and why.
const std::map<std::string, std::string> kUntested = {
    {"src/core/geometry/vec", "names of types only"},
    {"src/core/failure", "two members; tested by those who throw it: check_options, write_result"},
};

// The paths, without their ends, of core sources that lack tests/core/<folder>/<name>_test.cpp.
std::set<std::string> without_test(const std::set<std::string>& files) {
  std::set<std::string> missing;
  for (const std::string& file : files) {
    const fs::path path(file);
    if (file.rfind("src/core/", 0) != 0 || (path.extension() != ".h" && path.extension() != ".cpp")) continue;
    const std::string name = fs::path(path).replace_extension().generic_string();
    if (files.count("tests" + name.substr(3) + "_test.cpp") == 0) missing.insert(name);
  }
  return missing;
}

TEST(Includes, EveryCoreSourceHasItsTest) {
  std::set<std::string> files;
  const fs::path root(SOURCE_ROOT);
  for (const char* folder : {"src/core", "tests/core"})
    for (const auto& entry : fs::recursive_directory_iterator(root / folder))
      files.insert(entry.path().lexically_relative(root).generic_string());
  EXPECT_LE(kUntested.size(), 3U);
  std::set<std::string> excused;
  for (const auto& exception : kUntested) excused.insert(exception.first);
  const std::set<std::string> missing = without_test(files);
  for (const std::string& name : missing)
    if (excused.count(name) == 0) ADD_FAILURE() << name << " has no test";
  for (const std::string& name : excused)
    if (missing.count(name) == 0) ADD_FAILURE() << name << " needs no exception";
}

TEST(Includes, ASourceWithoutATestIsSeen) {
  EXPECT_EQ(
      without_test({"src/core/geometry/a.h", "src/core/geometry/a.cpp", "src/core/b.cpp",
                    "src/core/CMakeLists.txt", "tests/core/geometry/a_test.cpp", "tests/core/a_test.cpp"}),
      std::set<std::string>{"src/core/b"});
}

// A function of a file's own that begins a line, with the types of its parameters; else nothing.
std::string function_of(const std::string& line) {
  static const std::regex function("^\\w[\\w:<>,&* ]*[ &*](\\w+)\\(([^()]*)\\) \\{$"),
      parameter(" +\\w+(?=,|$)");
  std::smatch found;
  if (!std::regex_match(line, found, function)) return {};
  return found[1].str() + '(' + std::regex_replace(found[2].str(), parameter, "") + ')';
}

// Constants, types and functions declared where a line begins: of a whole file.
std::set<std::string> names_of(const std::string& text) {
  std::set<std::string> names;
  const std::regex constant("\\b(k[A-Z]\\w*)(?:\\[\\w*\\])* *[={]");
  const std::regex type("^(?:using (\\w+) *=|(?:struct|class|enum|enum class) (\\w+)(?: :[^:].*| *\\{))");
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (const std::string function = function_of(line); !function.empty()) names.insert(function);
    const bool constants = line.rfind("constexpr ", 0) == 0 || line.rfind("const ", 0) == 0;
    const std::regex& name = constants ? constant : type;
    for (std::sregex_iterator found(line.begin(), line.end(), name), end; found != end; ++found)
      names.insert((*found)[1].matched ? (*found)[1] : (*found)[2]);
  }
  return names;
}

// Names of two files that FILMSTICKING_BUILD_UNITY may compile as one.
std::vector<std::string> names_twice(const Sources& sources) {
  const std::regex alone(
      "/(delaunay|depth_image|initial_surface|regular)\\.cpp$");  // src/core/CMakeLists.txt
  std::vector<std::string> twice;
  std::map<std::string, std::string> file_of;  // by folder and name
  for (const auto& [path, text] : sources) {
    if (fs::path(path).extension() != ".cpp" || std::regex_search(path, alone)) continue;
    if (path.rfind("src/", 0) != 0 && path.rfind("apps/", 0) != 0) continue;
    for (const std::string& name : names_of(text)) {
      const auto [known, is_new] = file_of.emplace(fs::path(path).parent_path().string() + ' ' + name, path);
      if (!is_new) twice.push_back(name + " is in " + known->second + " and " + path);
    }
  }
  return twice;
}

TEST(Names, OfAFolderAreDifferent) {
  for (const std::string& fault : names_twice(read_sources())) ADD_FAILURE() << fault;
}

TEST(Names, ANameTwiceIsSeen) {
  Sources sources = {
      {"src/tools/io/a.cpp", "namespace {\nconstexpr double kNear = 1, kFar[2] = {2, 3};\n}\n"},
      {"src/tools/io/b.cpp", "void f() {\n  constexpr double kFar = 1;\n}\n"},
      {"src/tools/scene/c.cpp", "constexpr int kFar = 1;\n"},
      {"src/tools/io/f.cpp", "using other::Far;\n"},
      {"src/tools/io/g.cpp", "using other::Far;\n"}};
  EXPECT_TRUE(names_twice(sources).empty());
  sources["src/tools/io/d.cpp"] = "constexpr std::size_t kFar = 2;\nusing Near = int;\n";
  EXPECT_EQ(names_twice(sources).size(), 1U);
  sources["src/tools/io/e.cpp"] = "struct Near {\n};\n";
  EXPECT_EQ(names_twice(sources).size(), 2U);
  sources["src/tools/io/f.cpp"] += "bool is_near(const Point& p) {\n  return true;\n}\n";
  sources["src/tools/io/g.cpp"] += "bool is_near(double x) {\n  return true;\n}\n";
  EXPECT_EQ(names_twice(sources).size(), 2U);
  sources["src/tools/io/h.cpp"] = "static bool is_near(const Point& at) {\n  return true;\n}\n";
  EXPECT_EQ(names_twice(sources).size(), 3U);
}

}  // namespace
}  // namespace filmsticking
