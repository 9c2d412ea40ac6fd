// SPDX-License-Identifier: GPL-3.0-or-later
#include "on_ground.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "filter_error.h"
#include "io/cloud.h"

namespace filmsticking::filters {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kCell = 3;             // width of a cell, in usual distances between neighbours
constexpr double kNoise = 3;            // deviations from the plane that its points may have
constexpr double kLow = 1.5;            // cells; what is lower reaches the ground itself
constexpr double kThin = 0.6;           // cells; under what is lower the plane gets no points
constexpr std::size_t kLeastCells = 4;  // of a thing on the ground; fewer are noise
constexpr double kMostCells = 10'000'000;
constexpr std::size_t kMostAdded = 5'000'000;

/// A point by its place in the plane and its height.
struct Standing {
  std::size_t index;
  Vector2d place;
  double height;
};

/// Coordinates in the plane.
struct PlaneFrame {
  GroundPlane plane;
  Vector3d origin, u, v;

  PlaneFrame(const GroundPlane& ground, const Vector3d& near) : plane(ground) {
    origin = near - ground.up * ground.height(near);
    u = ground.up.unitOrthogonal();
    v = ground.up.cross(u);
  }
  Vector2d place(const Vector3d& p) const { return {u.dot(p - origin), v.dot(p - origin)}; }
  Vector3d point(const Vector2d& place, double height) const {
    return origin + u * place.x() + v * place.y() + plane.up * height;
  }
};

/// Of a cell. Above: an object, and the ground below it.
enum class Seen : char { Nothing, Outside, Ground, Above, Object };

/// What no point shows: from the outline of an object, or from a step of it, straight down.
struct Drop {
  double top, foot;  ///< heights
  Vector2d out;      ///< of length 1
};

/// The plane in cells, a border of empty ones around them.
class Footprint {
 public:
  Footprint(const std::vector<Standing>& objects, const std::vector<Vector2d>& ground, double width)
      : width_(width) {
    Vector2d least = objects[0].place, most = least;
    for (const Standing& p : objects) {
      least = least.cwiseMin(p.place);
      most = most.cwiseMax(p.place);
    }
    corner_ = least - Vector2d::Constant(2 * width);
    const Vector2d cells = (most - corner_) / width;
    if (!((cells.x() + 4) * (cells.y() + 4) <= kMostCells))
      throw FilterError("ground: the points above it are spread too far; --crop or --sor leaves strays out");
    columns_ = static_cast<int>(cells.x()) + 4;
    rows_ = static_cast<int>(cells.y()) + 4;
    const std::size_t count = std::size_t(columns_) * rows_;
    seen_.assign(count, Seen::Nothing);
    lowest_.assign(count, std::numeric_limits<double>::infinity());
    highest_.assign(count, 0);
    gap_low_.assign(count, 0);
    gap_high_.assign(count, 0);
    for (const Standing& p : objects) {
      const int cell = cell_of(p.place);
      seen_[cell] = Seen::Object;
      lowest_[cell] = std::min(lowest_[cell], p.height);
      highest_[cell] = std::max(highest_[cell], p.height);
    }
    std::vector<char> mixed(count, 0);
    for (const Vector2d& p : ground) {
      const int cell = cell_of(p);
      if (cell < 0) continue;
      if (seen_[cell] == Seen::Object) mixed[cell] = 1;
      if (seen_[cell] == Seen::Nothing) seen_[cell] = Seen::Ground;
    }
    find_gaps(objects);
    settle_mixed(mixed);
    drop_specks();
    flood();
  }

  /// -1: beyond the cells.
  int cell_of(const Vector2d& place) const {
    const Vector2d at = (place - corner_) / width_;
    if (!(at.x() >= 0 && at.y() >= 0 && at.x() < columns_ && at.y() < rows_)) return -1;
    return static_cast<int>(at.y()) * columns_ + static_cast<int>(at.x());
  }
  int count() const { return columns_ * rows_; }
  Vector2d middle(int cell) const {
    return corner_ + width_ * Vector2d(cell % columns_ + 0.5, cell / columns_ + 0.5);
  }
  bool is_object(int cell) const { return seen_[cell] == Seen::Object; }
  /// Whether the thing over the cell does not come down to the ground in it.
  bool floats(int cell) const {
    return seen_[cell] == Seen::Nothing || (is_object(cell) && lowest_[cell] > kThin * width_);
  }
  bool has_points(int cell) const { return is_object(cell) || seen_[cell] == Seen::Above; }
  /// Where an object's outline or a step of it is at this cell, if there is one: from its upper edge straight
  /// down no point was seen.
  std::optional<Drop> drop(int cell) const {
    if (!is_object(cell)) return std::nullopt;
    const std::array<int, 4> beside = {cell - 1, cell + 1, cell - columns_, cell + columns_};
    if (std::any_of(beside.begin(), beside.end(), [&](int other) { return open(other); }))
      return Drop{lowest_[cell], 0, out_of(cell, [&](int other) { return open(other); })};
    if (has_gap(cell)) {
      const Vector2d in = out_of(cell, [&](int other) {
        return is_object(other) && !has_gap(other) && lowest_[other] > gap_low_[cell] + kLow * width_;
      });
      if (!in.isZero()) return Drop{gap_high_[cell], gap_low_[cell], -in};
    }
    const auto steps_down = [&](int other) {
      return is_object(other) && highest_[other] < lowest_[cell] - kLow * width_;
    };
    double foot = -1;
    for (const int other : beside)
      if (steps_down(other)) foot = std::max(foot, highest_[other]);
    if (foot < 0) return std::nullopt;
    return Drop{lowest_[cell], foot, out_of(cell, steps_down)};
  }

  /// The up to eight around; cells at the border of the grid are empty, and have none.
  template <typename Visit>
  void for_neighbours(int cell, const Visit& visit) const {
    const int column = cell % columns_, row = cell / columns_;
    if (column == 0 || row == 0 || column + 1 == columns_ || row + 1 == rows_) return;
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x)
        if (x != 0 || y != 0) visit(cell + y * columns_ + x);
  }

 private:
  bool open(int cell) const { return seen_[cell] != Seen::Nothing && seen_[cell] != Seen::Object; }
  bool has_gap(int cell) const { return gap_high_[cell] > 0; }

  /// The mean direction to the neighbours that are `chosen`, of length 1; zero without any.
  template <typename Chosen>
  Vector2d out_of(int cell, const Chosen& chosen) const {
    Vector2d sum = Vector2d::Zero();
    for_neighbours(cell, [&](int other) {
      if (chosen(other)) sum += (middle(other) - middle(cell)).normalized();
    });
    return sum.stableNormalized();
  }

  /// The widest span of heights without a point in each cell, if it is a step.
  void find_gaps(const std::vector<Standing>& objects) {
    std::vector<std::pair<int, double>> heights;
    for (const Standing& p : objects) heights.emplace_back(cell_of(p.place), p.height);
    std::sort(heights.begin(), heights.end());
    for (std::size_t i = 1; i < heights.size(); ++i) {
      const auto [cell, height] = heights[i];
      const double below = heights[i - 1].second, gap = height - below;
      if (cell != heights[i - 1].first || gap <= kLow * width_ || gap <= gap_high_[cell] - gap_low_[cell])
        continue;
      gap_low_[cell] = below;
      gap_high_[cell] = height;
    }
  }

  /// A cell with ground and object is the object's outline beside cells of the object alone that are as high,
  /// or beside such an outline; elsewhere it is ground below something that juts out, or noise of the ground.
  void settle_mixed(const std::vector<char>& mixed) {
    std::vector<char> settled(seen_.size(), 0);
    for (std::size_t cell = 0; cell < seen_.size(); ++cell)
      settled[cell] = seen_[cell] == Seen::Object && mixed[cell] == 0 ? 1 : 0;
    for (int round = 0; round < 2; ++round) {
      const std::vector<char> before = settled;
      for (int cell = 0; cell < count(); ++cell)
        if (mixed[cell])
          for_neighbours(cell, [&](int other) {
            if (before[other] && (lowest_[cell] <= kLow * width_ || lowest_[other] > kLow * width_))
              settled[cell] = 1;
          });
    }
    for (int cell = 0; cell < count(); ++cell)
      if (mixed[cell] && !settled[cell])
        seen_[cell] = lowest_[cell] > kLow * width_ ? Seen::Above : Seen::Ground;
  }

  void drop_specks() {
    std::vector<char> visited(seen_.size(), 0);
    for (int first = 0; first < count(); ++first) {
      if (visited[first] || !has_points(first)) continue;
      std::vector<int> piece{first};
      visited[first] = 1;
      for (std::size_t k = 0; k < piece.size(); ++k)
        for_neighbours(piece[k], [&](int other) {
          if (visited[other] || !has_points(other)) return;
          visited[other] = 1;
          piece.push_back(other);
        });
      if (piece.size() < kLeastCells)
        for (const int cell : piece) seen_[cell] = Seen::Ground;
    }
  }

  /// Empty cells that are joined to the border through empty ones are outside; other empty ones are covered.
  void flood() {
    std::vector<int> wave;
    const auto reach = [&](int cell) {
      if (seen_[cell] != Seen::Nothing) return;
      seen_[cell] = Seen::Outside;
      wave.push_back(cell);
    };
    for (int cell = 0; cell < count(); ++cell) {
      const int column = cell % columns_, row = cell / columns_;
      if (column == 0 || row == 0 || column + 1 == columns_ || row + 1 == rows_) reach(cell);
      if (seen_[cell] == Seen::Ground || seen_[cell] == Seen::Above) for_neighbours(cell, reach);
    }
    while (!wave.empty()) {
      const int cell = wave.back();
      wave.pop_back();
      const int column = cell % columns_, row = cell / columns_;
      if (column > 0) reach(cell - 1);
      if (column + 1 < columns_) reach(cell + 1);
      if (row > 0) reach(cell - columns_);
      if (row + 1 < rows_) reach(cell + columns_);
    }
  }

  double width_;
  Vector2d corner_;
  int columns_ = 0, rows_ = 0;
  std::vector<Seen> seen_;
  std::vector<double> lowest_, highest_, gap_low_, gap_high_;
};

/// Points of the ground by their cell.
class GroundSeen {
 public:
  GroundSeen(const Footprint& footprint, const std::vector<Vector2d>& ground) : footprint_(footprint) {
    for (const Vector2d& p : ground) {
      const int cell = footprint.cell_of(p);
      if (cell >= 0) points_.emplace_back(cell, p);
    }
    std::stable_sort(points_.begin(), points_.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
  }

  /// Midway from an outermost point to the ground that is seen beyond it, in the direction `out` and no
  /// farther than `reach`: the outline is between the two.
  Vector2d midway(int cell, const Vector2d& place, const Vector2d& out, double reach) const {
    double nearest = reach;
    const auto look = [&](int at) {
      const auto first = std::lower_bound(points_.begin(), points_.end(), at,
                                          [](const auto& point, int c) { return point.first < c; });
      for (auto point = first; point != points_.end() && point->first == at; ++point) {
        const Vector2d step = point->second - place;
        const double along = step.dot(out);
        if (along > 0 && step.squaredNorm() - along * along < reach * reach / 4)
          nearest = std::min(nearest, along);
      }
    };
    look(cell);
    footprint_.for_neighbours(cell, look);
    return nearest < reach ? Vector2d(place + nearest / 2 * out) : place;
  }

 private:
  const Footprint& footprint_;
  std::vector<std::pair<int, Vector2d>> points_;
};

/// The grid on the plane, and columns below the outline.
std::vector<Vector3d> added_points(const Footprint& footprint, const std::vector<Standing>& objects,
                                   const GroundSeen& ground, const PlaneFrame& frame, double width) {
  // Of each cell with a drop the point at its top that is farthest out.
  std::vector<std::int32_t> outermost(footprint.count(), -1);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const int cell = footprint.cell_of(objects[i].place);
    const std::optional<Drop> drop = footprint.drop(cell);
    if (!drop || objects[i].height < drop->top) continue;
    std::int32_t& best = outermost[cell];
    if (best < 0 || drop->out.dot(objects[i].place - objects[best].place) > 0)
      best = static_cast<std::int32_t>(i);
  }
  std::vector<Vector3d> points;
  for (int cell = 0; cell < footprint.count(); ++cell) {
    const bool ends = outermost[cell] >= 0 && footprint.drop(cell)->foot == 0;
    if (outermost[cell] >= 0) {
      const Drop drop = *footprint.drop(cell);
      const Vector2d place = ground.midway(cell, objects[outermost[cell]].place, drop.out, width);
      for (int k = ends ? 0 : 1; k == 0 || drop.foot + k * width < drop.top - width / 2; ++k) {
        points.push_back(frame.point(place, drop.foot + k * width));
        if (points.size() > kMostAdded)
          throw FilterError(
              "ground: the points above it are spread too far; --crop or --sor leaves strays out");
      }
    }
    if (!ends && footprint.floats(cell)) points.push_back(frame.point(footprint.middle(cell), 0));
  }
  return points;
}

/// The cloud's rows of the indices, then rows of zeros with the positions.
pcl::PCLPointCloud2 joined(const pcl::PCLPointCloud2& cloud, const std::vector<int>& kept,
                           const std::vector<Vector3d>& added) {
  pcl::PCLPointCloud2 rows = io::make_rows(cloud.fields, cloud.point_step, kept.size() + added.size());
  rows.header = cloud.header;
  std::uint8_t* to = rows.data.data();
  for (const int point : kept)
    to = std::copy_n(io::bytes_of(cloud, static_cast<std::size_t>(point)), cloud.point_step, to);
  const io::PositionFields fields(rows);
  for (const Vector3d& p : added) {
    fields.store({p.x(), p.y(), p.z()}, to);
    to += cloud.point_step;
  }
  return rows;
}

}  // namespace

OnGround on_ground(const pcl::PCLPointCloud2& cloud, const GroundChoice& ground) {
  const std::vector<Point> positions = io::positions_of(cloud);
  OnGround result;
  result.plane = ground.plane ? *ground.plane : find_ground(positions);
  const double distance = usual_distance(positions), width = kCell * distance;
  if (!(distance > 0)) throw FilterError("ground: there are too few points");

  std::vector<double> heights;
  std::vector<std::size_t> finite;
  Vector3d middle = Vector3d::Zero();
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const Vector3d p(positions[i][0], positions[i][1], positions[i][2]);
    if (!p.allFinite()) continue;
    finite.push_back(i);
    heights.push_back(result.plane.height(p));
    middle += (p - middle) / static_cast<double>(finite.size());
  }
  const double tolerance = std::max(kNoise * ground_noise(heights, 2 * distance), distance / 4);
  const PlaneFrame frame(result.plane, middle);
  std::vector<Standing> objects;
  std::vector<Vector2d> on_plane;
  for (std::size_t k = 0; k < finite.size(); ++k) {
    const Point& p = positions[finite[k]];
    const Vector2d place = frame.place({p[0], p[1], p[2]});
    if (heights[k] > tolerance) {
      objects.push_back({finite[k], place, heights[k]});
    } else if (heights[k] >= -tolerance) {
      on_plane.push_back(place);
    }
  }
  if (objects.size() < 4) throw FilterError("ground: nothing stands on the plane " + to_text(result.plane));

  const Footprint footprint(objects, on_plane, width);
  std::vector<int> kept;
  std::vector<Standing> standing;
  for (const Standing& p : objects)
    if (footprint.has_points(footprint.cell_of(p.place))) {
      kept.push_back(static_cast<int>(p.index));
      standing.push_back(p);
    }
  if (kept.empty()) throw FilterError("ground: nothing stands on the plane " + to_text(result.plane));
  const std::vector<Vector3d> added = added_points(footprint, standing, {footprint, on_plane}, frame, width);
  result.on_plane = static_cast<std::int64_t>(positions.size() - kept.size());
  result.added = static_cast<std::int64_t>(added.size());
  result.points = joined(cloud, kept, added);
  return result;
}

}  // namespace filmsticking::filters
