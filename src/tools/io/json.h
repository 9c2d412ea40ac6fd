// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace filmsticking::io {

/// A value as JSON. Numbers keep every digit; one that is not finite is null, as JSON has none.
std::string json(bool value);
std::string json(int value);
std::string json(std::int64_t value);
std::string json(double value);
std::string json(std::string_view value);
inline std::string json(const char* value) { return json(std::string_view(value)); }
template <typename Value>
std::string json(const std::optional<Value>& value) {
  return value ? json(*value) : "null";
}

/// A JSON object. Members stand in the order in which they are added.
class JsonObject {
 public:
  template <typename Value>
  JsonObject& add(const char* name, const Value& value) {
    return add_json(name, json(value));
  }
  /// `value` is JSON already.
  JsonObject& add_json(const char* name, const std::string& value) {
    members_.emplace_back(name, value);
    return *this;
  }

  std::string one_line() const { return "{" + joined(" ", ",") + "}"; }
  /// A member a line.
  std::string lines() const { return "{\n" + joined("  ", ",\n") + "\n}\n"; }

 private:
  std::string joined(const std::string& before, const std::string& between) const;

  std::vector<std::pair<std::string, std::string>> members_;
};

}  // namespace filmsticking::io
