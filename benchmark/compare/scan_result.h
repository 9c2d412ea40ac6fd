// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "clouds/scan_kinds.h"
#include "row.h"

namespace filmsticking::bench {

/// What the judgement of a scan needs of a mesh.
struct ScanMeasures {
  double volume = 0;  ///< signed; of a closed, oriented mesh
  double area = 0;
  double longest_edge = 0;
  double main_share = 0;        ///< of the area, in the component that has most of it
  std::int64_t needed = 0;      ///< how many of Scan::needed are vertices
  int borders = 0;              ///< loops of edges with one face
  double used = 0;              ///< share of the points that are vertices
  std::optional<double> front;  ///< of the area, that faces what saw it; nothing where that is not known
};

ScanMeasures measure_scan(const Mesh& mesh, const Scan& scan);

/// One run of one method on one scan.
struct ScanResult {
  std::string kind, method;
  std::uint64_t seed = 0;
  std::size_t points = 0;
  Row row;                             ///< of the method's process, with what mesh_report says
  std::optional<double> over_truth;    ///< volume or area of the mesh over that of the truth
  std::optional<double> longest_edge;  ///< in sizes of the scan
  std::optional<double> main_share;
  std::optional<std::int64_t> needed, borders;
  std::optional<double> used, front;
  std::string wrong;  ///< the first thing that is; empty: the mesh is right
};

/// Fills in what `row` and the mesh say, and what is wrong. `measures` is null without a mesh.
void judge_scan(ScanResult& result, const Scan& scan, const ScanMeasures* measures);

/// The lines of the CSV, with their line feeds.
std::string scan_csv_header();
std::string scan_csv_line(const ScanResult& result);

}  // namespace filmsticking::bench
