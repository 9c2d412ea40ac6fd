// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

namespace filmsticking::io {

/// A file to be that gets its name when it is whole, and of which nothing is left otherwise; where the file
/// system knows files without names, also if the process is killed.
class NewFile {
 public:
  /// Opens a file in the folder of `target`. Throws std::system_error.
  explicit NewFile(const std::filesystem::path& target);
  ~NewFile();
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  /// Throws std::system_error.
  void append(std::string_view bytes);

  /// Puts the file in the place of `target`, whatever was there; nothing is appended after it. Throws
  /// std::system_error.
  void commit();

 private:
  void give_name();

  std::filesystem::path target_, temporary_;
  int file_ = -1;
  bool is_named_ = false;  // `temporary_` exists
};

}  // namespace filmsticking::io
