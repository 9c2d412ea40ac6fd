// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace filmsticking::io {

/// The lower-case extension of a path, with its dot.
std::string extension_of(const std::string& path);

/// Refuses what is not a regular file with something in it. Throws IoError.
void check_readable(const std::string& path);

/// All bytes of a file. Throws IoError.
std::string read_file(const std::string& path);

/// All bytes of standard input up to its end. Throws IoError, also where there are none.
std::string read_standard_input();

/// Throws IoError.
void write_standard_output(std::string_view bytes);

/// Refuses a path that write_file() could not replace, so that it is known before the work. Throws IoError.
void check_writable(const std::string& path);

/// Writes a new file or replaces a regular one; whatever happens, no half-written file has its name.
/// Throws IoError.
void write_file(const std::string& path, std::string_view bytes);

}  // namespace filmsticking::io
