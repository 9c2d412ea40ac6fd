// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace filmsticking::bench {

/// A table; the first row is the header. Columns but the first are set to the right.
std::string markdown_table(const std::vector<std::vector<std::string>>& rows);

/// A number for a table with so many digits, fewer behind the point where more stand before it; "-" for none.
std::string rounded(const std::optional<double>& value, int digits);

/// Writes a text to a file, or to the standard output if `path` is empty. Throws std::runtime_error.
void publish(const std::string& text, const std::string& path);

}  // namespace filmsticking::bench
