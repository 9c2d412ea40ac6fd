// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <charconv>
#include <filesystem>

#include "frame_source.h"
#include "io/files.h"
#include "stream_error.h"

namespace fs = std::filesystem;

namespace filmsticking::stream {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Compares characters, but runs of digits by their value.
bool natural_less(const std::string& a, const std::string& b) {
  std::size_t i = 0, k = 0;
  while (i < a.size() && k < b.size()) {
    if (!is_digit(a[i]) || !is_digit(b[k])) {
      if (a[i] != b[k]) return a[i] < b[k];
      ++i, ++k;
      continue;
    }
    const auto run = [](const std::string& text, std::size_t& at) {
      while (at < text.size() && text[at] == '0') ++at;
      const std::size_t begin = at;
      while (at < text.size() && is_digit(text[at])) ++at;
      return text.substr(begin, at - begin);
    };
    const std::string x = run(a, i), y = run(b, k);
    if (x.size() != y.size()) return x.size() < y.size();
    if (x != y) return x < y;
  }
  const bool a_left = i < a.size(), b_left = k < b.size();
  return a_left != b_left ? b_left : a < b;
}

}  // namespace

bool is_frame_file(const std::string& path) {
  const std::string extension = io::extension_of(path);
  for (const char* known : {".pcd", ".ply", ".las", ".ptx", ".pts", ".xyz"})
    if (extension == known) return true;
  return false;
}

std::vector<std::string> frame_files_in(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (is_frame_file(entry.path().string())) files.push_back(entry.path().string());
  if (error) throw StreamError(folder + ": " + error.message());
  if (files.empty())
    throw StreamError(folder + ": there are no .pcd, .ply, .las, .ptx, .pts or .xyz files in it");
  std::sort(files.begin(), files.end(), natural_less);
  return files;
}

std::optional<double> time_in_name(const std::string& path) {
  const std::string stem = fs::path(path).stem().string();
  std::size_t begin = stem.size();
  bool dot = false;
  while (begin > 0 && (is_digit(stem[begin - 1]) || (stem[begin - 1] == '.' && !dot))) {
    --begin;
    dot |= stem[begin] == '.';
  }
  if (begin < stem.size() && stem[begin] == '.') ++begin;
  double time = 0;
  const auto [rest, error] = std::from_chars(stem.data() + begin, stem.data() + stem.size(), time);
  if (error != std::errc() || rest != stem.data() + stem.size()) return std::nullopt;
  return time;
}

}  // namespace filmsticking::stream
