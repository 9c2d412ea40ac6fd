// SPDX-License-Identifier: GPL-3.0-or-later
#include "report.h"

#include <new>
#include <utility>

#include "extent.h"
#include "filmsticking/holes.h"
#include "self_intersections.h"

namespace filmsticking::mesh_report {
namespace {

std::vector<Hole> holes_of(const Surface& mesh) {
  std::vector<Point> positions;
  for (const Vec3& p : mesh.positions) positions.push_back({p.x(), p.y(), p.z()});
  std::vector<Hole> holes;
  if (find_holes(positions, mesh.triangles, holes) != Status::Ok) throw std::bad_alloc();
  return holes;
}

}  // namespace

Report report_on(const Surface& mesh) {
  Report report;
  report.vertices = static_cast<std::int64_t>(mesh.positions.size());
  report.faces = static_cast<std::int64_t>(mesh.triangles.size());
  report.topology = topology(mesh);
  SelfIntersections meetings = self_intersections(mesh);
  report.self_intersections = meetings.pairs;
  report.meeting_faces = std::move(meetings.face_meets);
  report.holes = holes_of(mesh);
  const Extent size = extent(mesh);
  report.area = size.area;
  report.parts = components(mesh);
  if (report.topology.closed && report.topology.oriented) report.volume = size.signed_volume;
  report.outward = report.volume && *report.volume > 0;
  return report;
}

GroundFit ground_fit(const Surface& mesh, const Topology& topology, const Vec3& up, double offset) {
  GroundFit fit{up, offset, {}};
  if (!mesh.triangles.empty() && topology.oriented) fit.volumes = plane_volumes(mesh, up, offset);
  return fit;
}

TruthFit truth_fit(const Surface& mesh, const Topology& mesh_topology, const Surface& truth,
                   std::size_t samples) {
  TruthFit fit;
  fit.distances = truth_distances(mesh, truth, samples);
  fit.sharp = sharp_edges(mesh, truth);
  const Topology truth_topology = topology(truth);
  fit.genus_right = mesh_topology.genus && mesh_topology.genus == truth_topology.genus;
  fit.components_right = mesh_topology.components == truth_topology.components;
  return fit;
}

}  // namespace filmsticking::mesh_report
