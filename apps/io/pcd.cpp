// SPDX-License-Identifier: GPL-3.0-or-later
#include "pcd.h"

#include <pcl/PCLPointCloud2.h>
#include <pcl/console/print.h>
#include <pcl/io/pcd_io.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "io_error.h"

namespace filmsticking::io {
namespace {

/// PCL reports in several lines of its own; here one sentence is enough.
class QuietPcl {
 public:
  QuietPcl() { pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS); }
  ~QuietPcl() { pcl::console::setVerbosityLevel(level_); }
  QuietPcl(const QuietPcl&) = delete;
  QuietPcl& operator=(const QuietPcl&) = delete;

 private:
  pcl::console::VERBOSITY_LEVEL level_ = pcl::console::getVerbosityLevel();
};

/// PCL trusts the header and reserves what it promises. This refuses a promise that the file cannot hold.
void check_header(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  double width = 0, height = 1, points = -1, values = 0, step = 0;
  std::vector<double> sizes;
  std::string text, data;
  while (data.empty() && std::getline(file, text)) {
    std::istringstream line(text);
    line.imbue(std::locale::classic());
    std::string keyword;
    line >> keyword;
    if (keyword == "WIDTH") line >> width;
    if (keyword == "HEIGHT") line >> height;
    if (keyword == "POINTS") line >> points;
    if (keyword == "SIZE") {
      for (double size; line >> size;) sizes.push_back(size);
      values = static_cast<double>(sizes.size());
      for (const double size : sizes) step += size;
    }
    if (keyword == "COUNT") {
      values = step = 0;
      double count = 0;
      for (std::size_t k = 0; k < sizes.size() && line >> count; ++k) {
        values += count;
        step += count * sizes[k];
      }
    }
    if (keyword == "DATA") line >> data;
  }
  if (data.empty()) throw IoError("it is not a PCD file");
  points = std::max(points, width * height);

  const auto body = static_cast<double>(std::filesystem::file_size(path)) - static_cast<double>(file.tellg());
  double room = body;
  double needed = points * step;
  if (data == "ascii") needed = points * values * 2 - 1;  // a digit and a blank
  if (data == "binary_compressed") room = body * 100;     // three bytes stand for up to 264
  if (needed > room) throw IoError("it ends before its PCD header says");
}

double value_at(const std::uint8_t* bytes, std::uint8_t type) {
  const auto as = [bytes](auto value) {
    std::memcpy(&value, bytes, sizeof value);
    return static_cast<double>(value);
  };
  switch (type) {
    case pcl::PCLPointField::INT8:
      return as(std::int8_t{});
    case pcl::PCLPointField::UINT8:
      return as(std::uint8_t{});
    case pcl::PCLPointField::INT16:
      return as(std::int16_t{});
    case pcl::PCLPointField::UINT16:
      return as(std::uint16_t{});
    case pcl::PCLPointField::INT32:
      return as(std::int32_t{});
    case pcl::PCLPointField::UINT32:
      return as(std::uint32_t{});
    case pcl::PCLPointField::FLOAT32:
      return as(float{});
    case pcl::PCLPointField::FLOAT64:
      return as(double{});
    default:
      throw IoError("its coordinates have an unknown type");
  }
}

const pcl::PCLPointField* find_field(const pcl::PCLPointCloud2& cloud, const std::string& name) {
  for (const pcl::PCLPointField& field : cloud.fields)
    if (field.name == name) return &field;
  return nullptr;
}

}  // namespace

Model read_pcd(const std::string& path) {
  check_header(path);
  const QuietPcl quiet;
  pcl::PCLPointCloud2 cloud;
  try {
    if (pcl::PCDReader().read(path, cloud) < 0) throw IoError("it is not a whole PCD file");
  } catch (const IoError&) {
    throw;
  } catch (const std::exception&) {
    throw IoError("it is not a whole PCD file");
  }

  const pcl::PCLPointField* axes[3] = {find_field(cloud, "x"), find_field(cloud, "y"),
                                       find_field(cloud, "z")};
  for (const pcl::PCLPointField* axis : axes)
    if (!axis) throw IoError("its points have no x, y and z");
  const pcl::PCLPointField* colour = find_field(cloud, "rgb");
  if (!colour) colour = find_field(cloud, "rgba");
  if (colour && colour->datatype != pcl::PCLPointField::FLOAT32 &&
      colour->datatype != pcl::PCLPointField::UINT32)
    colour = nullptr;

  const std::size_t count = std::size_t{cloud.width} * cloud.height;
  if (cloud.data.size() < count * cloud.point_step) throw IoError("it is not a whole PCD file");
  Model model;
  model.positions.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint8_t* point = cloud.data.data() + i * cloud.point_step;
    model.positions.push_back({value_at(point + axes[0]->offset, axes[0]->datatype),
                               value_at(point + axes[1]->offset, axes[1]->datatype),
                               value_at(point + axes[2]->offset, axes[2]->datatype)});
    if (!colour) continue;
    std::uint32_t rgb = 0;  // the same four bytes, whether the field calls itself float or whole number
    std::memcpy(&rgb, point + colour->offset, sizeof rgb);
    const auto channel = [rgb](int shift) { return static_cast<std::uint8_t>(rgb >> shift & 255); };
    model.colours.push_back({channel(16), channel(8), channel(0)});
  }
  return model;
}

}  // namespace filmsticking::io
