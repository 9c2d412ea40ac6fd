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

/// The most bytes that are read where nothing else is said: a quarter of the machine's memory, as the points
/// in them may take a few times as much.
std::int64_t most_bytes_read();

/// Refuses what is not a regular file with something in it, and more than `most` bytes, 0 meaning
/// most_bytes_read(). Throws IoError.
void check_readable(const std::string& path, std::int64_t most = 0);

/// All bytes of a file that check_readable() takes. Throws IoError.
std::string read_file(const std::string& path, std::int64_t most = 0);

/// All bytes of standard input up to its end, whatever it is: a pipe may have none. Throws IoError, also
/// where there are no bytes, more than `most`, or `stop` has become true.
std::string read_standard_input(std::int64_t most = 0, const std::atomic<bool>* stop = nullptr);

/// Throws IoError.
void write_standard_output(std::string_view bytes);

/// Refuses a path that write_file() could not replace, so that it is known before the work. Throws IoError.
void check_writable(const std::string& path);

/// Writes a new file or replaces a regular one with what `fill` sends; whatever happens, no half-written file
/// has its name. Throws IoError, and what `fill` throws.
void write_file(const std::string& path, const std::function<void(const ByteSink&)>& fill);
/// The same with bytes that are there already.
void write_file(const std::string& path, std::string_view bytes);

}  // namespace filmsticking::io
