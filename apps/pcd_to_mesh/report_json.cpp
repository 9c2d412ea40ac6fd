// SPDX-License-Identifier: GPL-3.0-or-later
#include "report_json.h"

#include <charconv>
#include <cstdio>
#include <string_view>
#include <utility>
#include <vector>

namespace filmsticking::app {
namespace {

std::string json(bool value) { return value ? "true" : "false"; }
std::string json(std::int64_t value) { return std::to_string(value); }
std::string json(int value) { return std::to_string(value); }

std::string json(double value) {
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

/// Members in the order in which they are added.
class Object {
 public:
  template <typename Value>
  Object& add(const char* name, const Value& value) {
    return add_json(name, json(value));
  }
  Object& add(const char* name, const char* value) { return add_json(name, json(std::string_view(value))); }
  Object& add_json(const char* name, const std::string& value) {
    members_.emplace_back(name, value);
    return *this;
  }

  std::string one_line() const { return "{" + joined(" ", ",") + "}"; }
  std::string lines() const { return "{\n" + joined("  ", ",\n") + "\n}\n"; }

 private:
  std::string joined(const std::string& before, const std::string& between) const {
    std::string text;
    for (const auto& [name, value] : members_) {
      if (!text.empty()) text += between;
      text += before + json(std::string_view(name)) + ": " + value;
    }
    return text;
  }

  std::vector<std::pair<std::string, std::string>> members_;
};

std::string list(const std::vector<Object>& objects) {
  std::string text;
  for (const Object& object : objects) text += (text.empty() ? "\n    " : ",\n    ") + object.one_line();
  return text.empty() ? "[]" : "[" + text + "\n  ]";
}

}  // namespace

std::string report_json(const Result& result, const RunFacts& facts) {
  const Report& report = result.report;
  std::vector<Object> steps, rooms;
  for (const StepRecord& step : report.steps)
    steps.push_back(Object()
                        .add("round", step.round)
                        .add("attracted", step.attracted)
                        .add("virtual_left", step.virtual_left)
                        .add("weighted", step.weighted)
                        .add("regions_repaired", step.regions_repaired)
                        .add("seconds", step.seconds));
  for (const RoomSeconds& room : report.rooms)
    rooms.push_back(Object().add("room", room.room).add("seconds", room.seconds));
  const double share =
      report.sites > 0 ? static_cast<double>(report.interpolated) / static_cast<double>(report.sites) : 0;

  return Object()
      .add("input", facts.input)
      .add("output", facts.output)
      .add("status", status_name(result.status))
      .add("message", result.message)
      .add("points", report.points)
      .add("sites", report.sites)
      .add("non_finite", report.non_finite)
      .add("duplicates", report.duplicates)
      .add("interpolated", report.interpolated)
      .add("interpolated_share", share)
      .add("inserted", report.inserted)
      .add("vertices", static_cast<std::int64_t>(result.vertices.size()))
      .add("triangles", static_cast<std::int64_t>(result.triangles.size()))
      .add("components", report.components)
      .add("genus", report.genus)
      .add("closed", report.closed)
      .add("manifold", report.manifold)
      .add("rounds", report.rounds)
      .add_json("steps", list(steps))
      .add_json("rooms", list(rooms))
      .add("reconstruction_seconds", report.seconds)
      .add("seconds", facts.seconds)
      .add("peak_memory_bytes", facts.peak_memory_bytes)
      .lines();
}

const char* status_name(Status status) {
  switch (status) {
    case Status::Ok:
      return "Ok";
    case Status::TooFewPoints:
      return "TooFewPoints";
    case Status::Coplanar:
      return "Coplanar";
    case Status::InvalidInput:
      return "InvalidInput";
    case Status::InvalidOptions:
      return "InvalidOptions";
    case Status::InvalidGuidingSurface:
      return "InvalidGuidingSurface";
    case Status::NoSurface:
      return "NoSurface";
    case Status::Cancelled:
      return "Cancelled";
    case Status::OutOfMemory:
      return "OutOfMemory";
    case Status::InternalError:
      return "InternalError";
  }
  return "InternalError";
}

}  // namespace filmsticking::app
