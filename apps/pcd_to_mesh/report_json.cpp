// SPDX-License-Identifier: GPL-3.0-or-later
#include "report_json.h"

#include <nlohmann/json.hpp>

namespace filmsticking::app {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const StepRecord& step) {
  return {{"round", step.round},       {"attracted", step.attracted}, {"virtual_left", step.virtual_left},
          {"weighted", step.weighted}, {"held", step.held},           {"seconds", step.seconds}};
}

Json to_json(const RoomSeconds& stage) { return {{"room", stage.room}, {"seconds", stage.seconds}}; }

Json to_json(const Hole& hole) {
  return {{"length", hole.length}, {"diameter", hole.diameter}, {"area", hole.area},
          {"centre", hole.centre}, {"normal", hole.normal},     {"edges", hole.edges},
          {"closed", hole.closed}};
}

template <typename Record>
Json to_list(const std::vector<Record>& records) {
  Json list = Json::array();
  for (const Record& record : records) list.push_back(to_json(record));
  return list;
}

}  // namespace

std::string report_json(const Result& result, const RunFacts& facts) {
  const Report& report = result.report;
  const double share =
      report.sites > 0 ? static_cast<double>(report.interpolated) / static_cast<double>(report.sites) : 0;
  Json json = {{"input", facts.input},
               {"output", facts.output},
               {"status", status_name(result.status)},
               {"message", result.message},
               {"warning", report.warning},
               {"notes", facts.notes},
               {"read", facts.read},
               {"points", report.points},
               {"sites", report.sites},
               {"non_finite", report.non_finite},
               {"duplicates", report.duplicates},
               {"interpolated", report.interpolated},
               {"interpolated_share", share},
               {"outliers", report.outliers},
               {"inserted", report.inserted},
               {"flips", report.flips},
               {"vertices", result.vertices.size()},
               {"triangles", result.triangles.size()},
               {"components", report.components},
               {"genus", report.genus},
               {"boundary_edges", report.boundary_edges},
               {"boundary_loops", report.boundary_loops},
               {"holes", to_list(report.holes)},
               {"closed", report.closed},
               {"manifold", report.manifold},
               {"stability", report.stability},
               {"rounds", report.rounds},
               {"steps", to_list(report.steps)},
               {"rooms", to_list(report.rooms)},
               {"reconstruction_seconds", report.seconds},
               {"seconds", facts.seconds},
               {"peak_memory_bytes", facts.peak_memory_bytes}};
  if (facts.ground) {
    const auto& up = facts.ground->up;
    json["ground"] = {up.x(), up.y(), up.z(), facts.ground->offset};
    json["on_ground"] = facts.on_ground;
    json["added"] = facts.added;
  }
  // A file's name may hold bytes that are not UTF-8; JSON has no place for them.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
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
