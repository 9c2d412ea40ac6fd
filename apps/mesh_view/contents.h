// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/cloud.h"
#include "scene/deviation.h"
#include "scene/drawing.h"
#include "scene/steps.h"
#include "view_state.h"

namespace filmsticking::app {

/// The meshes and points of mesh_view, and their distances, which are measured at the first request.
class Contents {
 public:
  /// `range`: the distance at the end of the colours; 0: chosen by the last film.
  Contents(std::vector<scene::Step> films, pcl::PCLPointCloud2 cloud,
           const std::optional<pcl::PolygonMesh>& reference, double range);

  Scope scope() const;
  const std::vector<scene::Step>& films() const { return films_; }
  const pcl::PCLPointCloud2& cloud() const { return cloud_; }

  /// For the faces (Paint::Faces) of a film, or for the points (Paint::Points) beside it; else empty.
  const scene::Values& values(Paint paint, std::size_t film);

  /// The distance at the end of the colours.
  double scale(Paint paint);

 private:
  std::vector<scene::Step> films_;
  pcl::PCLPointCloud2 cloud_;
  std::optional<scene::Deviation> reference_;
  double range_;
  std::map<std::pair<Paint, std::size_t>, scene::Values> values_;
};

/// One line about the mesh, the points and the colours shown.
std::string status_line(const Contents& contents, const ViewState& state);

}  // namespace filmsticking::app
