// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "bytes.h"

namespace filmsticking::io {

/// The lower-case extension of a path, with its dot.
std::string extension_of(const std::string& path);

/// The default bound on the bytes of an input: a quarter of the machine's memory, as its points may take a
/// few times as much.
std::int64_t most_bytes_read();

/// Refuses all but readable regular files of 1 to `most` bytes; 0: most_bytes_read(). Throws IoError.
void check_readable(const std::string& path, std::int64_t most = 0);

/// All bytes of a file that check_readable() accepts. Throws IoError.
std::string read_file(const std::string& path, std::int64_t most = 0);

/// All bytes of standard input up to its end. Throws IoError, also for no bytes, for more than `most`, and
/// once `stop` is true.
std::string read_standard_input(std::int64_t most = 0, const std::atomic<bool>* stop = nullptr);

/// Throws IoError.
void write_standard_output(std::string_view bytes);

/// Refuses a path that write_file() could not write, before the work. Throws IoError.
void check_writable(const std::string& path);

/// Writes a file with the bytes that `fill` sends, in place of a regular file of that name. No half-written
/// file ever has the name. Throws IoError, and what `fill` throws.
void write_file(const std::string& path, const std::function<void(const ByteSink&)>& fill);
/// The same for bytes in memory.
void write_file(const std::string& path, std::string_view bytes);

}  // namespace filmsticking::io
