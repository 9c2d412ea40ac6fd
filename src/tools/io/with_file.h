// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "io_error.h"

namespace filmsticking::io {

/// Runs `use` on a file and puts its name before what goes wrong with it. Throws IoError.
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
