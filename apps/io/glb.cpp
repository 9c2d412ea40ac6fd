// SPDX-License-Identifier: GPL-3.0-or-later
#include "glb.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "float_exact.h"
#include "io_error.h"

namespace filmsticking::io {
namespace {

Point middle_of(const std::vector<Point>& positions) {
  Point least = positions[0], most = positions[0];
  for (const Point& p : positions)
    for (int axis = 0; axis < 3; ++axis) {
      least[axis] = std::min(least[axis], p[axis]);
      most[axis] = std::max(most[axis], p[axis]);
    }
  return {(least[0] + most[0]) / 2, (least[1] + most[1]) / 2, (least[2] + most[2]) / 2};
}

/// A byte of sRGB, which is what cameras and PLY files have, as linear light.
std::uint16_t to_linear(std::uint8_t channel) {
  const double share = channel / 255.0;
  const double light = share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
  return static_cast<std::uint16_t>(std::lround(light * 65535));
}

/// Builds the one buffer of a glTF file; all its pieces are multiples of four bytes long, as they must be.
class BufferWriter {
 public:
  explicit BufferWriter(tinygltf::Model& gltf) : gltf_(gltf) { gltf_.buffers.emplace_back(); }

  template <typename Number, std::size_t N>
  tinygltf::Accessor& add(const std::vector<std::array<Number, N>>& rows, int target, int component, int type,
                          std::size_t count) {
    std::vector<unsigned char>& data = gltf_.buffers[0].data;
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = data.size();
    view.byteLength = rows.size() * sizeof rows[0];
    view.target = target;
    const auto* bytes = reinterpret_cast<const unsigned char*>(rows.data());
    data.insert(data.end(), bytes, bytes + view.byteLength);
    gltf_.bufferViews.push_back(view);

    tinygltf::Accessor accessor;
    accessor.bufferView = static_cast<int>(gltf_.bufferViews.size()) - 1;
    accessor.componentType = component;
    accessor.type = type;
    accessor.count = count;
    gltf_.accessors.push_back(accessor);
    return gltf_.accessors.back();
  }

 private:
  tinygltf::Model& gltf_;
};

/// Adds the positions, relative to `origin`.
void add_positions(const std::vector<Point>& positions, const Point& origin, BufferWriter& buffer) {
  constexpr double kMost = std::numeric_limits<float>::max();
  std::vector<std::array<float, 3>> rows;
  std::vector<double> least(3, kMost), most(3, -kMost);
  for (const Point& p : positions) {
    std::array<float, 3> row{};
    for (int axis = 0; axis < 3; ++axis) {
      const double x = p[axis] - origin[axis];
      if (!(std::abs(x) <= kMost)) throw IoError("glTF has no number for one of the coordinates");
      row[axis] = static_cast<float>(x);
      least[axis] = std::min<double>(least[axis], row[axis]);
      most[axis] = std::max<double>(most[axis], row[axis]);
    }
    rows.push_back(row);
  }
  tinygltf::Accessor& accessor = buffer.add(rows, TINYGLTF_TARGET_ARRAY_BUFFER, TINYGLTF_COMPONENT_TYPE_FLOAT,
                                            TINYGLTF_TYPE_VEC3, rows.size());
  accessor.minValues = least;
  accessor.maxValues = most;
}

void add_colours(const std::vector<Colour>& colours, BufferWriter& buffer) {
  std::vector<std::array<std::uint16_t, 4>> rows;
  rows.reserve(colours.size());
  for (const Colour& c : colours) rows.push_back({to_linear(c[0]), to_linear(c[1]), to_linear(c[2]), 65535});
  buffer
      .add(rows, TINYGLTF_TARGET_ARRAY_BUFFER, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_VEC4,
           rows.size())
      .normalized = true;
}

}  // namespace

std::string encode_glb(const Model& model) {
  if (model.triangles.empty()) throw IoError("there are no triangles for it");
  const Point origin = float_exact(model.positions) ? Point{0, 0, 0} : middle_of(model.positions);

  tinygltf::Model gltf;
  gltf.asset.version = "2.0";
  gltf.asset.generator = "FilmstickingPP";
  BufferWriter buffer(gltf);
  tinygltf::Primitive surface;
  surface.mode = TINYGLTF_MODE_TRIANGLES;
  surface.material = 0;
  surface.attributes["POSITION"] = 0;
  add_positions(model.positions, origin, buffer);
  surface.indices = 1;
  buffer.add(model.triangles, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT,
             TINYGLTF_TYPE_SCALAR, 3 * model.triangles.size());
  if (!model.colours.empty()) {
    surface.attributes["COLOR_0"] = 2;
    add_colours(model.colours, buffer);
  }

  tinygltf::Material material;  // neither metal nor gloss: the colours alone
  material.pbrMetallicRoughness.metallicFactor = 0;
  material.pbrMetallicRoughness.roughnessFactor = 1;
  gltf.materials = {material};
  tinygltf::Mesh mesh;
  mesh.primitives = {surface};
  gltf.meshes = {mesh};
  tinygltf::Node node;
  node.mesh = 0;
  if (origin != Point{0, 0, 0}) node.translation = {origin[0], origin[1], origin[2]};
  gltf.nodes = {node};
  tinygltf::Scene scene;
  scene.nodes = {0};
  gltf.scenes = {scene};
  gltf.defaultScene = 0;

  std::ostringstream bytes;
  tinygltf::TinyGLTF writer;
  if (!writer.WriteGltfSceneToStream(&gltf, bytes, false, true)) throw IoError("it cannot be written");
  return bytes.str();
}

}  // namespace filmsticking::io
