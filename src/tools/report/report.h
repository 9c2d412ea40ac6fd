// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "above_plane.h"
#include "cloud_fit.h"
#include "components.h"
#include "filmsticking/report.h"
#include "sharp_edges.h"
#include "topology.h"
#include "truth_fit.h"

namespace filmsticking::mesh_report {

/// A mesh against the true surface.
struct TruthFit {
  std::optional<TruthDistances> distances;
  SharpEdges sharp;
  bool genus_right = false;  ///< both have a genus, and it is the same
  bool components_right = false;
  bool topology_right() const { return genus_right && components_right; }
};

/// A mesh over a plane.
struct GroundFit {
  Vec3 up = Vec3::UnitZ();  ///< of length 1; the plane is up . p + offset = 0
  double offset = 0;
  std::optional<PlaneVolumes> volumes;  ///< in the mesh's unit cubed; only of an oriented mesh
};

/// All measurements of a mesh.
struct Report {
  std::string unit;  ///< of lengths, as it is printed; empty: unknown
  std::int64_t vertices = 0, faces = 0;
  Topology topology;
  std::int64_t self_intersections = 0;
  std::vector<char> meeting_faces;  ///< for each face whether it is in such a pair; not printed
  double area = 0;                  ///< in the mesh's unit squared
  std::optional<double> volume;     ///< in the mesh's unit cubed; only of a closed, oriented mesh
  std::vector<Component> parts;     ///< the largest area first
  std::vector<Hole> holes;          ///< loops of boundary edges, the widest first
  std::optional<GroundFit> ground;
  bool outward = false;  ///< closed, oriented, and the volume is positive
  std::optional<CloudFit> cloud;
  std::optional<TruthFit> truth;
};

/// Of the mesh alone.
Report report_on(const Surface& mesh);

GroundFit ground_fit(const Surface& mesh, const Topology& topology, const Vec3& up, double offset);

TruthFit truth_fit(const Surface& mesh, const Topology& topology, const Surface& truth, std::size_t samples);

/// The lines of the table for people: a name and a value.
std::vector<std::pair<std::string, std::string>> table_rows(const Report& report);

/// That table in two columns.
std::string to_text(const Report& report);

/// One JSON object; a measurement without a value is null. Members of the cloud and of the truth only
/// with these.
std::string to_json(const Report& report);

}  // namespace filmsticking::mesh_report
