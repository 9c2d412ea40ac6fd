// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace filmsticking::bench {

/// A line of comma-separated values (RFC 4180, but a line feed ends it and none is inside).
std::string csv_line(const std::vector<std::string>& fields);

/// The fields of such a line, without its line feed.
std::vector<std::string> csv_fields(const std::string& line);

}  // namespace filmsticking::bench
