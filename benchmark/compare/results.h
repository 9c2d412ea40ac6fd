// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "row.h"

namespace filmsticking::bench {

/// The rows of a CSV file, which grows row by row, so that a stopped run can be resumed.
class Results {
 public:
  /// Takes up what the file holds, unless `fresh`; an empty path keeps the rows in memory only. Throws
  /// std::runtime_error if the file is no table of ours or cannot be written.
  Results(std::string path, bool fresh);

  bool has(const Row& row) const;

  /// Adds a row and writes it out at once. Can be called from many threads.
  void add(const Row& row);

  /// The row of the same key, or null.
  const Row* find(const Row& row) const;

 private:
  void read();
  void rewrite() const;

  std::string path_;
  mutable std::mutex mutex_;
  std::map<std::string, Row> rows_;  // by key; a later row replaces an earlier one
  std::vector<std::string> order_;
};

}  // namespace filmsticking::bench
