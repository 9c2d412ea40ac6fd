// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a fuzz target on files, and on all files of folders, that are handed to it; without libFuzzer.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "target.h"

namespace fs = std::filesystem;

namespace {

int run_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> bytes(std::istreambuf_iterator<char>(file), {});
  if (file.bad()) return std::fprintf(stderr, "%s cannot be read\n", path.c_str()), 1;
  std::fprintf(stderr, "%s\n", path.filename().c_str());  // before it runs: the last one is the culprit
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  return 0;
}

int run_all(int count, char** paths) {
  int faults = 0, runs = 0;
  for (int k = 1; k < count; ++k) {
    if (!fs::is_directory(paths[k])) {
      faults += run_file(paths[k]), ++runs;
      continue;
    }
    for (const auto& entry : fs::directory_iterator(paths[k])) faults += run_file(entry.path()), ++runs;
  }
  std::fprintf(stderr, "%d inputs\n", runs);
  return faults > 0 || runs == 0 ? 1 : 0;
}

}  // namespace

int main(int count, char** paths) {
  try {
    return run_all(count, paths);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
