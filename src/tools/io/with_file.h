// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "io_error.h"

namespace filmsticking::io {

/// Runs `use` and prefixes its errors with the file's name. Throws IoError.
template <typename Use>
auto with_file(const std::string& path, Use use) {
  try {
    return use();
  } catch (const IoError& error) {
    throw IoError(path + ": " + error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    throw IoError(path + ": " + error.code().message());
  }
}

}  // namespace filmsticking::io
