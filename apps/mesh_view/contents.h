// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/model.h"
#include "scene/deviation.h"
#include "scene/drawing.h"
#include "scene/steps.h"
#include "view_state.h"

namespace filmsticking::app {

/// The things of mesh_view, and how far they are from each other; that is measured when it is first asked
/// for.
class Contents {
 public:
  /// `range`: the distance at the end of the colours; 0: chosen by the last film.
  Contents(std::vector<scene::Step> films, io::Model cloud, std::optional<io::Model> reference, double range);

  Scope scope() const;
  const std::vector<scene::Step>& films() const { return films_; }
  const io::Model& cloud() const { return cloud_; }

  /// For the faces (Paint::Faces) of a film, or for the points (Paint::Points) beside it; else empty.
  const scene::Values& values(Paint paint, std::size_t film);

  /// The distance at the end of the colours.
  double scale(Paint paint);

 private:
  std::vector<scene::Step> films_;
  io::Model cloud_;
  std::optional<scene::Deviation> reference_;
  double range_;
  std::map<std::pair<Paint, std::size_t>, scene::Values> values_;
};

/// One line on what is shown.
std::string status_line(const Contents& contents, const ViewState& state);

}  // namespace filmsticking::app
