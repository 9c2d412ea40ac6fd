// SPDX-License-Identifier: GPL-3.0-or-later
#include "report_json.h"

#include <vector>

#include "io/json.h"

namespace filmsticking::app {
namespace {

using io::JsonObject;

std::string list(const std::vector<JsonObject>& objects) {
  std::string text;
  for (const JsonObject& object : objects) text += (text.empty() ? "\n    " : ",\n    ") + object.one_line();
  return text.empty() ? "[]" : "[" + text + "\n  ]";
}

}  // namespace

std::string report_json(const Result& result, const RunFacts& facts) {
  const Report& report = result.report;
  std::vector<JsonObject> steps, rooms;
  for (const StepRecord& step : report.steps)
    steps.push_back(JsonObject()
                        .add("round", step.round)
                        .add("attracted", step.attracted)
                        .add("virtual_left", step.virtual_left)
                        .add("weighted", step.weighted)
                        .add("regions_repaired", step.regions_repaired)
                        .add("seconds", step.seconds));
  for (const RoomSeconds& room : report.rooms)
    rooms.push_back(JsonObject().add("room", room.room).add("seconds", room.seconds));
  const double share =
      report.sites > 0 ? static_cast<double>(report.interpolated) / static_cast<double>(report.sites) : 0;

  return JsonObject()
      .add("input", facts.input)
      .add("output", facts.output)
      .add("status", status_name(result.status))
      .add("message", result.message)
      .add("read", facts.read)
      .add("points", report.points)
      .add("sites", report.sites)
      .add("non_finite", report.non_finite)
      .add("duplicates", report.duplicates)
      .add("interpolated", report.interpolated)
      .add("interpolated_share", share)
      .add("outliers", report.outliers)
      .add("inserted", report.inserted)
      .add("flips", report.flips)
      .add("vertices", static_cast<std::int64_t>(result.vertices.size()))
      .add("triangles", static_cast<std::int64_t>(result.triangles.size()))
      .add("components", report.components)
      .add("genus", report.genus)
      .add("boundary_edges", report.boundary_edges)
      .add("boundary_loops", report.boundary_loops)
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
    case Status::TooComplex:
      return "TooComplex";
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
