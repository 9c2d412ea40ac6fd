// SPDX-License-Identifier: GPL-3.0-or-later
#include "contents.h"

#include <algorithm>
#include <utility>

#include "report/scale_length.h"

namespace filmsticking::app {

Contents::Contents(std::vector<scene::Step> films, pcl::PCLPointCloud2 cloud,
                   const std::optional<pcl::PolygonMesh>& reference, double range)
    : films_(std::move(films)), cloud_(std::move(cloud)), range_(range) {
  if (reference) reference_.emplace(*reference);
}

Scope Contents::scope() const {
  Scope scope;
  scope.films = films_.size();
  scope.points = io::size_of(cloud_) > 0;
  const bool colours =
      !io::colours_of(cloud_).empty() || std::any_of(films_.begin(), films_.end(), [](const scene::Step& s) {
        return !io::colours_of(s.film.cloud).empty();
      });
  if (colours) scope.paints.push_back(Paint::Colours);
  if (reference_ && scope.films > 0) scope.paints.push_back(Paint::Faces);
  if (scope.points && scope.films > 0) scope.paints.push_back(Paint::Points);
  return scope;
}

const scene::Values& Contents::values(Paint paint, std::size_t film) {
  const auto [known, is_new] = values_.try_emplace({paint, film});
  if (is_new && paint == Paint::Faces) known->second = reference_->of_faces(films_[film].film);
  if (is_new && paint == Paint::Points)
    known->second = scene::Deviation(films_[film].film).of_points(io::positions_of(cloud_));
  return known->second;
}

double Contents::scale(Paint paint) {
  if (range_ > 0 || films_.empty()) return range_ > 0 ? range_ : 1;
  return mesh_report::scale_length(values(paint, films_.size() - 1));
}

std::string status_line(const Contents& contents, const ViewState& state) {
  std::string line;
  const std::size_t films = contents.films().size();
  if (films > 0) {
    const scene::Step& film = contents.films()[state.film];
    line = film.name;
    if (films > 1) line += " (" + std::to_string(state.film + 1) + " of " + std::to_string(films) + ")";
    line += ", " + std::to_string(film.film.polygons.size()) + " faces";
  }
  const std::size_t points = io::size_of(contents.cloud());
  if (points > 0) line += (line.empty() ? "" : ", ") + std::to_string(points) + " points";
  if (state.paint == Paint::Colours) line += ", colours of the files";
  if (state.paint == Paint::Faces) line += ", faces by distance";
  if (state.paint == Paint::Points) line += ", points by distance";
  return line + "   (h: keys)";
}

}  // namespace filmsticking::app
