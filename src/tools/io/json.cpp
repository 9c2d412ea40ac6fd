// SPDX-License-Identifier: GPL-3.0-or-later
#include "json.h"

#include <charconv>
#include <cmath>
#include <cstdio>

namespace filmsticking::io {

std::string json(bool value) { return value ? "true" : "false"; }
std::string json(int value) { return std::to_string(value); }
std::string json(std::int64_t value) { return std::to_string(value); }

std::string json(double value) {
  if (!std::isfinite(value)) return "null";
  char digits[64];
  return std::string(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

std::string json(std::string_view value) {
  std::string text = "\"";
  for (const char c : value) {
    if (c == '"' || c == '\\') {
      text += '\\';
      text += c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned>(c));
      text += escape;
    } else {
      text += c;
    }
  }
  return text + '"';
}

std::string JsonObject::joined(const std::string& before, const std::string& between) const {
  std::string text;
  for (const auto& [name, value] : members_) {
    if (!text.empty()) text += between;
    text.append(before).append(json(std::string_view(name))).append(": ").append(value);
  }
  return text;
}

}  // namespace filmsticking::io
