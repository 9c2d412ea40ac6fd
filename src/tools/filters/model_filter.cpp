// SPDX-License-Identifier: GPL-3.0-or-later
#include "model_filter.h"

#include <cmath>

#include "filter_chain.h"
#include "io/float_exact.h"
#include "position_fields.h"

namespace filmsticking::filters {
namespace {

/// A point as the filters see it; `source` is dropped where points are made anew.
struct Row {
  float x, y, z;
  std::uint8_t blue, green, red, alpha;
  std::int32_t source;
};

pcl::PCLPointField field(const char* name, std::size_t offset, std::uint8_t type) {
  pcl::PCLPointField field;
  field.name = name;
  field.offset = static_cast<std::uint32_t>(offset);
  field.datatype = type;
  field.count = 1;
  return field;
}

/// What is subtracted so that single precision suffices; nothing where it does already, since the voxels of
/// a grid should be where PCL's are.
Point origin_of(const std::vector<Point>& positions) {
  if (io::float_exact(positions)) return {0, 0, 0};
  for (const Point& p : positions)
    if (std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2])) return p;
  return {0, 0, 0};
}

pcl::PCLPointCloud2 to_cloud(const io::Model& model, const Point& origin) {
  using Type = pcl::PCLPointField;
  pcl::PCLPointCloud2 cloud;
  cloud.fields = {field("x", offsetof(Row, x), Type::FLOAT32), field("y", offsetof(Row, y), Type::FLOAT32),
                  field("z", offsetof(Row, z), Type::FLOAT32),
                  field("source", offsetof(Row, source), Type::INT32)};
  if (!model.colours.empty()) cloud.fields.push_back(field("rgb", offsetof(Row, blue), Type::FLOAT32));
  cloud.point_step = sizeof(Row);
  cloud.height = 1;
  for (std::size_t i = 0; i < model.positions.size(); ++i) {
    Row row{};
    float* const to[3] = {&row.x, &row.y, &row.z};
    for (int axis = 0; axis < 3; ++axis) {
      const double x = model.positions[i][axis] - origin[axis];
      *to[axis] = std::abs(x) < 1e30 ? static_cast<float>(x) : NAN;  // no filter could reckon with it
    }
    if (!model.colours.empty()) {
      row.red = model.colours[i][0];
      row.green = model.colours[i][1];
      row.blue = model.colours[i][2];
      row.alpha = 255;
    }
    row.source = static_cast<std::int32_t>(i);
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(&row);
    cloud.data.insert(cloud.data.end(), bytes, bytes + sizeof row);
  }
  cloud.width = static_cast<std::uint32_t>(model.positions.size());
  cloud.row_step = static_cast<std::uint32_t>(cloud.data.size());
  return cloud;
}

/// Where a field's bytes are, or nothing.
std::optional<std::size_t> offset_of(const pcl::PCLPointCloud2& cloud, const char* name) {
  for (const pcl::PCLPointField& field : cloud.fields)
    if (field.name == name) return field.offset;
  return std::nullopt;
}

/// The points in the box, by their exact positions.
io::Model cropped(const io::Model& model, const Box& box) {
  io::Model kept;
  kept.viewpoint = model.viewpoint;
  for (std::size_t i = 0; i < model.positions.size(); ++i) {
    const Point& p = model.positions[i];
    bool inside = true;
    for (int axis = 0; axis < 3; ++axis) inside &= box.least[axis] <= p[axis] && p[axis] <= box.most[axis];
    if (!inside) continue;
    kept.positions.push_back(p);
    if (!model.colours.empty()) kept.colours.push_back(model.colours[i]);
  }
  return kept;
}

}  // namespace

io::Model filter(const io::Model& model, const FilterOptions& options) {
  check(options);
  if (!options.any()) return model;
  if (options.crop) {
    FilterOptions rest = options;
    rest.crop.reset();
    return filter(cropped(model, *options.crop), rest);
  }
  const Point origin = origin_of(model.positions);
  const pcl::PCLPointCloud2 cloud = filter(to_cloud(model, origin), options);

  io::Model kept;
  kept.viewpoint = model.viewpoint;
  const PositionFields fields(cloud);
  const auto source_at = offset_of(cloud, "source"), colour_at = offset_of(cloud, "rgb");
  for (std::size_t i = 0; i < cloud.width; ++i) {
    const std::uint8_t* point = cloud.data.data() + i * cloud.point_step;
    if (source_at && !options.smoothing) {
      std::int32_t source = 0;
      std::memcpy(&source, point + *source_at, sizeof source);
      kept.positions.push_back(model.positions[source]);
    } else {
      const std::array<float, 3> p = fields.load(point);
      kept.positions.push_back({origin[0] + p[0], origin[1] + p[1], origin[2] + p[2]});
    }
    if (colour_at) {
      const std::uint8_t* colour = point + *colour_at;  // blue, green, red, alpha
      kept.colours.push_back({colour[2], colour[1], colour[0]});
    }
  }
  return kept;
}

}  // namespace filmsticking::filters
