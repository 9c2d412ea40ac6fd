// SPDX-License-Identifier: GPL-3.0-or-later
#include "files.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

#include "io_error.h"
#include "large_pages.h"

namespace fs = std::filesystem;

namespace filmsticking::io {
namespace {

/// The target of a link, which is replaced in place of the link.
fs::path target_of(const std::string& path) {
  std::error_code error;
  const fs::path target = fs::weakly_canonical(path, error);
  return error ? fs::path(path) : target;
}

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

const char* const kOpenFiles = "/proc/self/fd/";

[[noreturn]] void throw_last_error() { throw std::system_error(errno, std::generic_category()); }

/// A file that gets its name once it is whole, and vanishes otherwise; on file systems with nameless files,
/// also if the process is killed.
class NewFile {
 public:
  /// Opens a file in the folder of `target`. Throws std::system_error.
  explicit NewFile(const std::filesystem::path& target);
  ~NewFile();
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  /// Throws std::system_error.
  void append(std::string_view bytes);

  /// Puts the file in the place of `target`; nothing is appended after that. Throws std::system_error.
  void commit();

 private:
  void give_name();

  std::filesystem::path target_, temporary_;
  int file_ = -1;
  bool is_named_ = false;  // `temporary_` exists
};

NewFile::NewFile(const fs::path& target)
    : target_(target),
      temporary_(folder_of(target) /
                 ("." + target.filename().string() + "." + std::to_string(getpid()) + ".tmp")) {
  // A nameless file gets its name by its place among the open files.
  if (access(kOpenFiles, X_OK) == 0)
    file_ = open(folder_of(target).c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0666);
  if (file_ >= 0) return;
  unlink(temporary_.c_str());
  file_ = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file_ < 0) throw_last_error();
  is_named_ = true;
}

NewFile::~NewFile() {
  if (file_ >= 0) close(file_);
  if (is_named_) unlink(temporary_.c_str());
}

void NewFile::append(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t size = write(file_, bytes.data(), bytes.size());
    if (size < 0 && errno != EINTR) throw_last_error();
    bytes.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
  }
}

void NewFile::give_name() {
  unlink(temporary_.c_str());
  const std::string open_file = kOpenFiles + std::to_string(file_);
  if (linkat(AT_FDCWD, open_file.c_str(), AT_FDCWD, temporary_.c_str(), AT_SYMLINK_FOLLOW) != 0)
    throw_last_error();
  is_named_ = true;
}

void NewFile::commit() {
  if (!is_named_) give_name();
  const int file = file_;
  file_ = -1;
  if (close(file) != 0) throw_last_error();
  fs::rename(temporary_, target_);
  is_named_ = false;
}

std::int64_t bound_of(std::int64_t most) { return most > 0 ? most : most_bytes_read(); }

[[noreturn]] void throw_large(std::int64_t most) {
  throw IoError("it is larger than " + std::to_string(most / 1000000) + " MB, the most that is read");
}

}  // namespace

std::string extension_of(const std::string& path) {
  std::string extension = fs::path(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

void check_readable(const std::string& path, std::int64_t most) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) throw IoError("there is no such file");
  if (!fs::is_regular_file(status)) throw IoError("it is not a file");
  if (access(path.c_str(), R_OK) != 0) throw IoError("it cannot be read");
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) throw IoError("it cannot be read");
  if (size == 0) throw IoError("it is empty");
  if (size > static_cast<std::uintmax_t>(bound_of(most))) throw_large(bound_of(most));
}

std::int64_t most_bytes_read() {
  const long pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGESIZE);
  return pages > 0 && page > 0 ? std::int64_t{pages} * page / 4 : std::int64_t{1} << 30;
}

std::string read_file(const std::string& path, std::int64_t most) {
  check_readable(path, most);
  std::error_code error;
  std::ifstream file(path, std::ios::binary);
  std::string bytes;
  const std::uintmax_t size = fs::file_size(path, error);
  bytes.reserve(size);
  prefer_large_pages(bytes.data(), bytes.capacity());
  bytes.resize(size);
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (error || !file) throw IoError("it cannot be read");
  return bytes;
}

std::string read_standard_input(std::int64_t most, const std::atomic<bool>* stop) {
  const auto bound = static_cast<std::size_t>(bound_of(most));
  std::string bytes;
  char piece[1 << 16];
  for (;;) {
    const ssize_t size = read(STDIN_FILENO, piece, sizeof piece);
    if (stop && *stop) throw IoError("interrupted");
    if (size < 0 && errno == EINTR) continue;
    if (size < 0) throw IoError("it cannot be read");
    if (size == 0) break;
    if (static_cast<std::size_t>(size) > bound - bytes.size()) throw_large(bound_of(most));
    bytes.append(piece, static_cast<std::size_t>(size));
  }
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

void write_file(const std::string& path, const std::function<void(const ByteSink&)>& fill) {
  check_writable(path);
  try {
    NewFile file(target_of(path));
    fill([&](std::string_view bytes) { file.append(bytes); });
    file.commit();
  } catch (const std::system_error& error) {
    throw IoError("it cannot be written: " + error.code().message());
  }
}

void write_file(const std::string& path, std::string_view bytes) {
  write_file(path, [&](const ByteSink& sink) { sink(bytes); });
}

}  // namespace filmsticking::io
