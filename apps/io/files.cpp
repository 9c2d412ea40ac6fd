// SPDX-License-Identifier: GPL-3.0-or-later
#include "files.h"

#include <unistd.h>

#include <cctype>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "io_error.h"

namespace fs = std::filesystem;

namespace filmsticking::io {
namespace {

/// Where the bytes go: a link's target is replaced, not the link.
fs::path target_of(const std::string& path) {
  std::error_code error;
  const fs::path target = fs::weakly_canonical(path, error);
  return error ? fs::path(path) : target;
}

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

}  // namespace

std::string extension_of(const std::string& path) {
  std::string extension = fs::path(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

void check_readable(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) throw IoError("there is no such file");
  if (!fs::is_regular_file(status)) throw IoError("it is not a file");
  if (access(path.c_str(), R_OK) != 0) throw IoError("it cannot be read");
  if (fs::file_size(path, error) == 0) throw IoError("it is empty");
}

std::string read_file(const std::string& path) {
  check_readable(path);
  std::error_code error;
  std::ifstream file(path, std::ios::binary);
  std::string bytes;
  bytes.resize(fs::file_size(path, error));
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (error || !file) throw IoError("it cannot be read");
  return bytes;
}

std::string read_standard_input() {
  std::string bytes;
  char piece[1 << 16];
  for (std::size_t size; (size = std::fread(piece, 1, sizeof piece, stdin)) > 0;) bytes.append(piece, size);
  if (std::ferror(stdin)) throw IoError("it cannot be read");
  if (bytes.empty()) throw IoError("it is empty");
  return bytes;
}

void write_standard_output(std::string_view bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size() || std::fflush(stdout) != 0)
    throw IoError("it cannot be written");
}

void check_writable(const std::string& path) {
  const fs::path target = target_of(path);
  std::error_code error;
  if (fs::exists(target, error) && !fs::is_regular_file(target, error))
    throw IoError("it is there already and not a file");
  if (!fs::is_directory(folder_of(target), error)) throw IoError("its folder does not exist");
  if (access(folder_of(target).c_str(), W_OK) != 0) throw IoError("its folder cannot be written to");
}

void write_file(const std::string& path, std::string_view bytes) {
  check_writable(path);
  const fs::path target = target_of(path);
  const fs::path temporary =
      folder_of(target) / ("." + target.filename().string() + "." + std::to_string(getpid()) + ".tmp");
  std::error_code error;
  {
    std::ofstream file(temporary, std::ios::binary | std::ios::trunc);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file) {
      fs::remove(temporary, error);
      throw IoError("it cannot be written");
    }
  }
  fs::rename(temporary, target, error);
  if (error) {
    const std::string reason = error.message();
    fs::remove(temporary, error);
    throw IoError("it cannot be written: " + reason);
  }
}

}  // namespace filmsticking::io
