// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure.h"

#include <cstring>
#include <nlohmann/json.hpp>

namespace filmsticking::bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kOutOfMemory = 3;          // exit code of run_method
constexpr double kReportSeconds = 3600;  // far above what mesh_report needs

/// The last line that is not empty.
std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of(" \r\n");
  if (end == std::string::npos) return "";
  const std::size_t before = text.find_last_of('\n', end),
                    begin = before == std::string::npos ? 0 : before + 1;
  return text.substr(begin, end - begin + 1);
}

/// A value as a cell of a table: a string without its quotes, nothing for null.
std::string cell(const Json& value) {
  if (value.is_null()) return "";
  return value.is_string() ? value.get<std::string>() : value.dump();
}

/// The status of a run without a mesh.
void set_failure(Row& row, const ChildEnd& end, const Limits& limits) {
  const std::string said = last_line(end.err);
  if (end.timed_out) {
    row.set("status", "time limit");
    row.set("message", "killed after " + to_text(limits.seconds) + " s");
  } else if (end.code == kOutOfMemory || end.err.find("bad_alloc") != std::string::npos) {
    row.set("status", "out of memory");
    row.set("message", said);
  } else if (end.signal != 0) {
    row.set("status", "crashed");
    row.set("message", std::string(strsignal(end.signal)) + (said.empty() ? "" : ": " + said));
  } else {
    row.set("status", "failed");
    row.set("message", said.empty() ? "exit code " + std::to_string(end.code) : said);
  }
}

void set_timings(Row& row, const Json& json) {
  for (const char* column : {"seconds", "seconds_with_needs", "cpu_seconds", "memory_mb"})
    row.set(column, cell(json.at(column)));
  const double taken = json.at("memory_mb").get<double>() - json.at("memory_before_mb").get<double>();
  row.set("bytes_per_point",
          std::to_string(static_cast<long long>(1e6 * taken / json.at("points").get<double>())));
  row.set("message", cell(json.at("warning")));
  std::string stages;
  for (const auto& [stage, seconds] : json.at("rooms").items())
    stages += (stages.empty() ? "" : ";") + stage + "=" + cell(seconds);
  row.set("rooms", stages);
  if (json.at("steps").get<int>() == 0) return;  // no film
  for (const char* column : {"steps", "fields"}) row.set(column, cell(json.at(column)));
}

void set_judgement(Row& row, const CloudFiles& files, const std::string& mesh) {
  std::vector<std::string> command = {sibling_program("mesh_report"), mesh, "--points", files.cloud,
                                      "--json"};
  if (!files.truth.empty()) command.insert(command.end(), {"--truth", files.truth});
  const ChildEnd end = run_child(command, {kReportSeconds, 0});
  if (end.code != 0) {
    row.set("status", "not judged");
    row.set("message", "mesh_report: " + last_line(end.err));
    return;
  }
  const Json json = Json::parse(end.out);
  for (const std::string& column : judged_columns()) row.set(column, cell(json.value(column, Json())));
}

}  // namespace

Row planned_row(const Row& cloud, const std::string& method, const Measurement& measurement) {
  Row row = cloud;
  row.set("method", method);
  row.set("threads", measurement.threads > 0 ? std::to_string(measurement.threads) : "all");
  row.set("run", std::to_string(measurement.run));
  return row;
}

Row measure(const CloudFiles& files, const std::string& method, const MethodEntry& entry,
            const std::string& mesh, const Measurement& measurement) {
  Row row = planned_row(files.row, method, measurement);
  row.set("timing", measurement.timing_fit ? "fit" : "unfit");
  std::vector<std::string> command = {entry.program, method, files.cloud, mesh,
                                      std::to_string(measurement.threads)};
  if (const auto& d = files.direction; d && entry.needs_sight)
    command.push_back(to_text((*d)[0]) + "," + to_text((*d)[1]) + "," + to_text((*d)[2]));
  const ChildEnd end = run_child(command, measurement.limits, measurement.threads);
  if (end.timed_out || end.signal != 0 || end.code != 0) {
    set_failure(row, end, measurement.limits);
    return row;
  }
  row.set("status", "ok");
  try {
    set_timings(row, Json::parse(last_line(end.out)));
    if (measurement.judge && entry.makes_mesh) set_judgement(row, files, mesh);
  } catch (const Json::exception& error) {
    row.set("status", "not judged");
    row.set("message", error.what());
  }
  return row;
}

}  // namespace filmsticking::bench
