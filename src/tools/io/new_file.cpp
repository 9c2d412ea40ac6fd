// SPDX-License-Identifier: GPL-3.0-or-later
#include "new_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <system_error>

namespace fs = std::filesystem;

namespace filmsticking::io {
namespace {

const char* const kOpenFiles = "/proc/self/fd/";

[[noreturn]] void throw_last_error() { throw std::system_error(errno, std::generic_category()); }

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

}  // namespace

NewFile::NewFile(const fs::path& target)
    : target_(target),
      temporary_(folder_of(target) /
                 ("." + target.filename().string() + "." + std::to_string(getpid()) + ".tmp")) {
  // A file without a name gets one by its place among the open files.
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

}  // namespace filmsticking::io
