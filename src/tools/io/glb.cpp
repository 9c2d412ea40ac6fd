// SPDX-License-Identifier: GPL-3.0-or-later
// By hand: VTK's exporter needs a scene to render, and assimp keeps no double coordinates.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "codecs.h"
#include "io_error.h"

namespace filmsticking::io {
namespace {

using Json = nlohmann::ordered_json;

// Numbers of the glTF 2.0 specification.
constexpr std::uint32_t kMagic = 0x46546c67, kVersion = 2, kJsonChunk = 0x4e4f534a, kBinaryChunk = 0x004e4942;
constexpr int kUnsignedShort = 5123, kUnsignedInt = 5125, kFloat = 5126;
constexpr int kVertices = 34962, kIndices = 34963;

struct Box {
  Point least, most;
};

Box box_of(const std::vector<Point>& positions) {
  Box box{positions[0], positions[0]};
  for (const Point& p : positions)
    for (int axis = 0; axis < 3; ++axis) {
      box.least[axis] = std::min(box.least[axis], p[axis]);
      box.most[axis] = std::max(box.most[axis], p[axis]);
    }
  return box;
}

/// From where the coordinates count: 0 where single precision keeps them, otherwise the middle of the box.
Point origin_of(bool exact, const Box& box) {
  Point origin{};
  if (!exact)
    for (int axis = 0; axis < 3; ++axis) origin[axis] = (box.least[axis] + box.most[axis]) / 2;
  return origin;
}

/// Throws IoError.
void check_range(const std::vector<Point>& positions, const Point& origin) {
  for (const Point& p : positions)
    for (int axis = 0; axis < 3; ++axis)
      if (!(std::abs(p[axis] - origin[axis]) <= std::numeric_limits<float>::max()))
        throw IoError("glTF has no number for one of the coordinates");
}

/// A byte of sRGB, which is what cameras and PLY files have, as linear light.
std::uint16_t to_linear(std::uint8_t channel) {
  const double share = channel / 255.0;
  const double light = share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
  return static_cast<std::uint16_t>(std::lround(light * 65535));
}

/// The nearest floats to `p` counted from `origin`.
Json floats(const Point& p, const Point& origin) {
  Json numbers;
  for (int axis = 0; axis < 3; ++axis)
    numbers.push_back(static_cast<double>(static_cast<float>(p[axis] - origin[axis])));
  return numbers;
}

/// The arrays of the binary chunk, one behind the other, in the order of append_arrays().
struct Arrays {
  /// `accessor`: the members that only this array has.
  void add(Json accessor, int component, const char* type, std::size_t count, std::size_t size, int target) {
    views.push_back({{"buffer", 0}, {"byteOffset", bytes}, {"byteLength", count * size}, {"target", target}});
    accessor.update(
        {{"bufferView", accessors.size()}, {"componentType", component}, {"type", type}, {"count", count}});
    accessors.push_back(std::move(accessor));
    bytes += count * size;
  }

  Json views = Json::array(), accessors = Json::array();
  std::size_t bytes = 0;
};

/// The description of the mesh, and the size of the binary chunk.
struct Scene {
  std::string json;
  std::size_t binary;
};

Scene describe(std::size_t vertices, std::size_t corners, bool coloured, const Box& box,
               const Point& origin) {
  Arrays arrays;
  arrays.add({{"min", floats(box.least, origin)}, {"max", floats(box.most, origin)}}, kFloat, "VEC3",
             vertices, 12, kVertices);
  arrays.add(Json::object(), kUnsignedInt, "SCALAR", corners, 4, kIndices);
  Json attributes = {{"POSITION", 0}};
  if (coloured) {
    arrays.add({{"normalized", true}}, kUnsignedShort, "VEC4", vertices, 8, kVertices);
    attributes["COLOR_0"] = 2;
  }
  const Json primitive = {{"attributes", attributes}, {"indices", 1}, {"material", 0}};
  Json node = {{"mesh", 0}};
  if (origin != Point{}) node["translation"] = origin;
  // Neither metal nor gloss: the colours alone.
  const Json material = {{"pbrMetallicRoughness", {{"metallicFactor", 0}, {"roughnessFactor", 1}}}};
  const Json scene = {{"asset", {{"version", "2.0"}, {"generator", "FilmstickingPP"}}},
                      {"scene", 0},
                      {"scenes", Json::array({{{"nodes", Json::array({0})}}})},
                      {"nodes", Json::array({node})},
                      {"meshes", Json::array({{{"primitives", Json::array({primitive})}}})},
                      {"materials", Json::array({material})},
                      {"accessors", arrays.accessors},
                      {"bufferViews", arrays.views},
                      {"buffers", Json::array({{{"byteLength", arrays.bytes}}})}};
  return {scene.dump(), arrays.bytes};
}

void append_arrays(const std::vector<Point>& positions, const std::vector<Triangle>& triangles,
                   const std::vector<Colour>& colours, const Point& origin, ByteWriter& out) {
  for (const Point& p : positions)
    out.add([&](std::string& bytes) {
      for (int axis = 0; axis < 3; ++axis) append(bytes, static_cast<float>(p[axis] - origin[axis]));
    });
  for (const Triangle& triangle : triangles)
    out.add([&](std::string& bytes) {
      for (const std::int32_t corner : triangle) append(bytes, corner);
    });
  for (const Colour& colour : colours)
    out.add([&](std::string& bytes) {
      for (const std::uint8_t channel : colour) append(bytes, to_linear(channel));
      append(bytes, std::uint16_t{65535});
    });
}

}  // namespace

void encode_glb(const pcl::PCLPointCloud2& vertices, const std::vector<Triangle>& triangles,
                ByteWriter& out) {
  if (triangles.empty()) throw IoError("there are no triangles for it");
  const std::vector<Point> positions = positions_of(vertices);
  const std::vector<Colour> colours = colours_of(vertices);
  const Box box = box_of(positions);
  const Point origin = origin_of(float_exact(vertices), box);
  check_range(positions, origin);
  Scene scene = describe(positions.size(), 3 * triangles.size(), !colours.empty(), box, origin);
  scene.json.resize((scene.json.size() + 3) / 4 * 4, ' ');  // chunks are of whole words

  constexpr std::size_t kHeaders = 12 + 8 + 8;
  const std::size_t size = kHeaders + scene.json.size() + scene.binary;
  if (size > std::numeric_limits<std::uint32_t>::max()) throw IoError("it is larger than a .glb file can be");
  const auto add_words = [&](std::initializer_list<std::size_t> words) {
    out.add([&](std::string& bytes) {
      for (const std::size_t word : words) append(bytes, static_cast<std::uint32_t>(word));
    });
  };
  add_words({kMagic, kVersion, size, scene.json.size(), kJsonChunk});
  out.append(scene.json);
  add_words({scene.binary, kBinaryChunk});
  append_arrays(positions, triangles, colours, origin, out);
}

}  // namespace filmsticking::io
