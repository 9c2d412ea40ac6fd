// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace filmsticking::bench {

/// A mesh or a cloud to compare on.
struct Input {
  std::string name;  ///< in the tables: the file's name without its extension, or the shape's
  std::string path;  ///< of the file; empty for a generated shape
};

/// The inputs that the command line names: files or shapes. Throws std::runtime_error if two have one name.
std::vector<Input> make_inputs(const std::vector<std::string>& words);

/// The paths of a list file, taken from its folder on: one a line, empty lines and those that begin with #
/// left out. A .tsv file is a table instead: the paths are in its column "file", and only the rows that have
/// every value of `where` (column, value) count. Throws std::runtime_error.
std::vector<std::string> read_list(const std::string& path,
                                   const std::vector<std::pair<std::string, std::string>>& where);

}  // namespace filmsticking::bench
