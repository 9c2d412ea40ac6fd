// SPDX-License-Identifier: GPL-3.0-or-later
#include "mean_cloud.h"

#include <algorithm>
#include <cmath>

namespace filmsticking::stream {

MeanCloud::MeanCloud(double width, std::size_t most) : width_(width), most_(most) {}

void MeanCloud::Sum::see(const Point& from, double distance) {
  if (distance < from_sensor) sensor = from, from_sensor = distance;
}

MeanCloud::Sum& MeanCloud::sum_of(const Cell& cell) {
  const auto [found, is_new] = index_of_.try_emplace(cell, cells_.size());
  if (is_new) cells_.emplace_back().cell = cell;
  return cells_[found->second];
}

void MeanCloud::add(const std::vector<Point>& points, const std::vector<io::Colour>& colours,
                    const std::optional<Point>& sensor) {
  ++frame_;
  seen_ = seen_ || sensor;
  coloured_ = coloured_ && !colours.empty();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Cell cell = cell_of(points[i], width_);
    if (!std::all_of(cell.begin(), cell.end(), [](double x) { return std::abs(x) < 1e15; })) continue;
    Sum& sum = sum_of(cell);
    for (int axis = 0; axis < 3; ++axis) {
      sum.position[axis] += points[i][axis];
      if (coloured_) sum.colour[axis] += colours[i][axis];
    }
    if (sensor)
      sum.see(*sensor, std::hypot(points[i][0] - (*sensor)[0], points[i][1] - (*sensor)[1],
                                  points[i][2] - (*sensor)[2]));
    ++sum.points;
    if (sum.last_frame != frame_) ++sum.frames;
    sum.last_frame = frame_;
    while (cells_.size() > most_) coarsen();
  }
}

void MeanCloud::coarsen() {
  const std::vector<Sum> fine = std::move(cells_);
  cells_.clear();
  index_of_.clear();
  width_ *= 2;
  for (const Sum& part : fine) {
    Sum& sum = sum_of(cell_of(part.cell, 2));
    for (int axis = 0; axis < 3; ++axis) {
      sum.position[axis] += part.position[axis];
      sum.colour[axis] += part.colour[axis];
    }
    sum.see(part.sensor, part.from_sensor);
    sum.points += part.points;
    sum.frames = std::max(sum.frames, part.frames);
    sum.last_frame = std::max(sum.last_frame, part.last_frame);
  }
}

std::vector<Point> MeanCloud::positions(std::uint32_t frames) const {
  std::vector<Point> means;
  for (const Sum& sum : cells_) {
    if (sum.frames < frames) continue;
    const double n = sum.points;
    means.push_back({sum.position[0] / n, sum.position[1] / n, sum.position[2] / n});
  }
  return means;
}

pcl::PCLPointCloud2 MeanCloud::cloud(std::uint32_t frames) const {
  std::vector<io::Colour> colours;
  for (const Sum& sum : cells_) {
    if (!coloured_ || sum.frames < frames) continue;
    const double n = sum.points;
    io::Colour& colour = colours.emplace_back();
    for (int channel = 0; channel < 3; ++channel)
      colour[channel] = static_cast<std::uint8_t>(std::lround(sum.colour[channel] / n));
  }
  pcl::PCLPointCloud2 cloud = io::make_cloud(positions(frames), colours);
  if (!seen_) return cloud;
  std::vector<Point> sensors;
  for (const Sum& sum : cells_)
    if (sum.frames >= frames) sensors.push_back(sum.sensor);
  return io::with_stations(cloud, sensors);
}

}  // namespace filmsticking::stream
