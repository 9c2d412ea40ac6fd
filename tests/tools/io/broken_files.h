// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "io/files.h"
#include "io/formats.h"
#include "support/model.h"
#include "support/scratch_folder.h"

namespace filmsticking::test {

/// A file of one of the formats that the programs read.
struct Sample {
  std::string name;       ///< "ply_big_endian"
  std::string extension;  ///< ".ply"
  std::string bytes;
};

/// Of every format whose files say how long they are: five coloured points, four triangles where the format
/// has some.
inline std::vector<Sample> samples() {
  const float xyz[5][3] = {{0, 0, 0}, {1.25f, 0, -1e-7f}, {0, 1.5f, 0}, {0.125f, 0.25f, 2}, {3, 3, 3}};
  const std::int32_t faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  std::vector<Sample> samples;

  const ScratchFolder folder;
  pcl::PointCloud<pcl::PointXYZRGB> cloud;
  for (const auto& p : xyz) {
    pcl::PointXYZRGB point(p[0], p[1], p[2]);
    point.r = 200, point.g = 100, point.b = 50;
    cloud.push_back(point);
  }
  pcl::PCDWriter writer;
  writer.writeASCII(folder / "ascii", cloud, 9);
  writer.writeBinary(folder / "binary", cloud);
  writer.writeBinaryCompressed(folder / "compressed", cloud);
  for (const char* name : {"ascii", "binary", "compressed"})
    samples.push_back({std::string("pcd_") + name, ".pcd", io::read_file(folder / name)});

  const auto append = [](std::string& bytes, auto value, bool big_endian) {
    std::string raw(sizeof value, '\0');
    std::memcpy(raw.data(), &value, sizeof value);
    bytes += big_endian ? std::string(raw.rbegin(), raw.rend()) : raw;
  };
  for (const std::string format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    std::string bytes =
        "ply\nformat " + format +
        " 1.0\ncomment made for a test\nelement vertex 5\nproperty float x\nproperty float y\n"
        "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
        "element face 4\nproperty list uchar int vertex_indices\nend_header\n";
    const bool text = format == "ascii", big_endian = format == "binary_big_endian";
    for (const auto& p : xyz) {
      for (const float x : p) text ? void(bytes += std::to_string(x) + ' ') : append(bytes, x, big_endian);
      text ? void(bytes += "200 100 50\n") : void(bytes += "\xc8\x64\x32");
    }
    for (const auto& face : faces) {
      text ? void(bytes += "3") : void(bytes += '\3');
      for (const std::int32_t k : face)
        text ? void(bytes += ' ' + std::to_string(k)) : append(bytes, k, big_endian);
      if (text) bytes += '\n';
    }
    samples.push_back({"ply_" + format, ".ply", bytes});
  }

  Model mesh;
  for (const auto& p : xyz) mesh.positions.push_back({p[0], p[1], p[2]});
  for (const auto& face : faces) mesh.triangles.push_back({face[0], face[1], face[2]});
  samples.push_back({"stl_binary", ".stl", io::encode_mesh("stl", mesh)});
  mesh.positions[3][2] = 0.1;  // no float
  samples.push_back({"stl_text", ".stl", io::encode_mesh("stl", mesh)});
  return samples;
}

}  // namespace filmsticking::test
