// SPDX-License-Identifier: GPL-3.0-or-later
#include "distances.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>

#include "report/point_distance.h"
#include "report/scale_length.h"
#include "report/surface_distance.h"

namespace filmsticking::page {
namespace {

using mesh_report::Surface;
using mesh_report::Vec3;

constexpr int kBins = 60;

/// The corners of all faces, then their middles.
std::vector<Vec3> probes(const Surface& mesh) {
  std::vector<Vec3> places = mesh.positions;
  places.reserve(places.size() + mesh.triangles.size());
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
    places.push_back(mesh.corner(f, 0) / 3 + mesh.corner(f, 1) / 3 + mesh.corner(f, 2) / 3);
  return places;
}

std::vector<double> largest_of_faces(const Surface& mesh, const std::vector<double>& of_probes) {
  std::vector<double> faces(of_probes.begin() + static_cast<std::ptrdiff_t>(mesh.positions.size()),
                            of_probes.end());
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (const std::int32_t corner : mesh.triangles[f]) faces[f] = std::max(faces[f], of_probes[corner]);
  return faces;
}

}  // namespace

std::vector<double> faces_to_truth(const Surface& mesh, const Surface& truth) {
  // In the truth's unit box: large coordinates would cost digits.
  const mesh_report::Frame frame = mesh_report::frame_of(truth.positions);
  const Surface unit = frame.to_unit(truth);
  std::vector<double> distances;
  for (const mesh_report::Nearest& nearest :
       mesh_report::SurfaceDistance(unit).from(probes(frame.to_unit(mesh))))
    distances.push_back(nearest.distance * (frame.side > 0 ? frame.side : 1));
  return largest_of_faces(mesh, distances);
}

std::vector<double> faces_to_points(const Surface& mesh, const std::vector<Vec3>& points) {
  return largest_of_faces(mesh, mesh_report::PointDistance(points).from(probes(mesh)));
}

Painting paint(std::string title, const std::vector<double>& distances) {
  Painting result;
  result.title = std::move(title);
  result.length = mesh_report::scale_length(distances);
  result.bins.assign(kBins, 0);
  result.colours.reserve(distances.size());
  for (const double distance : distances) {
    const double share = distance / result.length;
    result.colours.push_back(static_cast<std::uint8_t>(255 * std::min(share, 1.0) + 0.5));
    if (share > 1) {
      ++result.beyond;
    } else {
      ++result.bins[std::min(static_cast<int>(share * kBins), kBins - 1)];
    }
  }
  if (distances.empty()) return result;
  result.largest = *std::max_element(distances.begin(), distances.end());
  result.mean =
      std::accumulate(distances.begin(), distances.end(), 0.0) / static_cast<double>(distances.size());
  return result;
}

nlohmann::ordered_json Painting::facts() const {
  return {{"title", title},     {"length", length}, {"mean", mean},
          {"largest", largest}, {"bins", bins},     {"beyond", beyond}};
}

}  // namespace filmsticking::page
