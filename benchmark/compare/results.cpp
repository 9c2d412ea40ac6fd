// SPDX-License-Identifier: GPL-3.0-or-later
#include "results.h"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "csv.h"
#include "io/files.h"
#include "io/io_error.h"

namespace filmsticking::bench {
namespace {

std::string line_of(const Row& row) {
  std::vector<std::string> fields;
  for (const std::string& column : columns()) fields.push_back(row.text(column));
  return csv_line(fields);
}

}  // namespace

Results::Results(std::string path, bool fresh) : path_(std::move(path)) {
  if (path_.empty()) return;
  try {
    io::check_writable(path_);
    if (!fresh && std::filesystem::exists(path_)) read();
    rewrite();
  } catch (const io::IoError& error) {
    throw std::runtime_error(path_ + ": " + error.what());
  }
}

void Results::read() {
  std::istringstream lines(io::read_file(path_));
  std::string line;
  if (!std::getline(lines, line) || line + '\n' != csv_line(columns()))
    throw std::runtime_error(path_ + ": it is not a table of these columns; --fresh replaces it");
  while (std::getline(lines, line)) {
    const std::vector<std::string> fields = csv_fields(line);
    if (lines.eof() || fields.size() != columns().size()) continue;  // interrupted while it was written
    Row row;
    for (std::size_t i = 0; i < fields.size(); ++i) row.set(columns()[i], fields[i]);
    if (rows_.insert_or_assign(row.key(), row).second) order_.push_back(row.key());
  }
}

void Results::rewrite() const {
  std::string text = csv_line(columns());
  for (const std::string& key : order_) text += line_of(rows_.at(key));
  io::write_file(path_, text);
}

const Row* Results::find(const Row& row) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = rows_.find(row.key());
  return found == rows_.end() ? nullptr : &found->second;
}

bool Results::has(const Row& row) const { return find(row) != nullptr; }

void Results::add(const Row& row) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (rows_.insert_or_assign(row.key(), row).second) order_.push_back(row.key());
  if (path_.empty()) return;
  std::ofstream file(path_, std::ios::app | std::ios::binary);
  file << line_of(row) << std::flush;
  if (!file) throw std::runtime_error(path_ + ": it cannot be written");
}

}  // namespace filmsticking::bench
