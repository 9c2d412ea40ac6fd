// SPDX-License-Identifier: GPL-3.0-or-later
#include "markdown.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "io/files.h"
#include "io/io_error.h"

namespace filmsticking::bench {

std::string markdown_table(const std::vector<std::vector<std::string>>& rows) {
  std::string text;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    text += "|";
    for (const std::string& cell : rows[i]) text += " " + cell + " |";
    text += "\n";
    if (i > 0) continue;
    text += "|";
    for (std::size_t k = 0; k < rows[i].size(); ++k) text += k == 0 ? "---|" : "---:|";
    text += "\n";
  }
  return text;
}

std::string rounded(const std::optional<double>& value, int digits) {
  if (!value) return "-";
  if (*value == 0) return "0";
  constexpr int kMostDecimals = 4;
  const int before = static_cast<int>(std::floor(std::log10(std::abs(*value)))) + 1;
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", std::clamp(digits - before, 0, kMostDecimals), *value);
  return text;
}

void publish(const std::string& text, const std::string& path) {
  if (path.empty()) {
    std::fputs(text.c_str(), stdout);
    return;
  }
  try {
    io::write_file(path, text);
  } catch (const io::IoError& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

}  // namespace filmsticking::bench
