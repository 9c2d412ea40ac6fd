// SPDX-License-Identifier: GPL-3.0-or-later
#include "input.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>
#include <stdexcept>

#include "clouds/shapes.h"
#include "io/files.h"
#include "io/io_error.h"

namespace fs = std::filesystem;

namespace filmsticking::bench {
namespace {

std::vector<std::string> tab_fields(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, '\t');) fields.push_back(field);
  return fields;
}

}  // namespace

std::vector<Input> make_inputs(const std::vector<std::string>& words) {
  std::vector<Input> inputs;
  std::set<std::string> names;
  for (const std::string& word : words) {
    const Input input = is_shape(word) ? Input{word, ""} : Input{fs::path(word).stem().string(), word};
    if (!names.insert(input.name).second)
      throw std::runtime_error("two inputs have the name " + input.name +
                               ", so the table cannot distinguish them");
    inputs.push_back(input);
  }
  return inputs;
}

std::vector<std::string> read_list(const std::string& path,
                                   const std::vector<std::pair<std::string, std::string>>& where) {
  std::string text;
  try {
    text = io::read_file(path);
  } catch (const io::IoError& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
  const bool table = io::extension_of(path) == ".tsv";
  if (!table && !where.empty())
    throw std::runtime_error(path + ": only a .tsv file has columns to choose by");
  std::vector<std::string> header, files;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty() || line[0] == '#') continue;
    std::string file = line;
    if (table) {
      const std::vector<std::string> fields = tab_fields(line);
      if (header.empty()) {
        header = fields;
        continue;
      }
      const auto value = [&](const std::string& column) {
        const auto at =
            static_cast<std::size_t>(std::find(header.begin(), header.end(), column) - header.begin());
        if (at == header.size()) throw std::runtime_error(path + ": it has no column \"" + column + "\"");
        return at < fields.size() ? fields[at] : std::string();
      };
      const bool chosen = std::all_of(where.begin(), where.end(),
                                      [&](const auto& wish) { return value(wish.first) == wish.second; });
      if (!chosen) continue;
      file = value("file");
    }
    files.push_back(is_shape(file) ? file : (fs::path(path).parent_path() / file).string());
  }
  if (files.empty()) throw std::runtime_error(path + ": it names no file");
  return files;
}

}  // namespace filmsticking::bench
