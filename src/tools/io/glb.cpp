// SPDX-License-Identifier: GPL-3.0-or-later
#include "glb.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "float_exact.h"
#include "io_error.h"
#include "json.h"
#include "scalar.h"

namespace filmsticking::io {
namespace {

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
Point origin_of(const std::vector<Point>& positions, const Box& box) {
  Point origin{};
  if (!float_exact(positions))
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

std::string json_array(const std::vector<std::string>& values) {
  std::string text = "[";
  for (const std::string& value : values) text += (text.size() > 1 ? "," : "") + value;
  return text + "]";
}

/// The nearest floats to `p` counted from `origin`, as JSON.
std::string json_point(const Point& p, const Point& origin) {
  std::vector<std::string> numbers;
  numbers.reserve(3);
  for (int axis = 0; axis < 3; ++axis)
    numbers.push_back(json(static_cast<double>(static_cast<float>(p[axis] - origin[axis]))));
  return json_array(numbers);
}

/// Lists the arrays of the binary chunk, one behind the other.
class Arrays {
 public:
  /// `accessor` has what is particular to it; returns the array's number.
  std::int64_t add(JsonObject accessor, int component, const char* type, std::size_t count, std::size_t bytes,
                   int target) {
    const auto number = static_cast<std::int64_t>(views_.size());
    views_.push_back(JsonObject()
                         .add("buffer", 0)
                         .add("byteOffset", static_cast<std::int64_t>(bytes_))
                         .add("byteLength", static_cast<std::int64_t>(bytes))
                         .add("target", target)
                         .one_line());
    accessors_.push_back(accessor.add("bufferView", number)
                             .add("componentType", component)
                             .add("type", type)
                             .add("count", static_cast<std::int64_t>(count))
                             .one_line());
    bytes_ += bytes;
    return number;
  }

  std::size_t bytes() const { return bytes_; }
  std::string views() const { return json_array(views_); }
  std::string accessors() const { return json_array(accessors_); }

 private:
  std::vector<std::string> views_, accessors_;
  std::size_t bytes_ = 0;
};

/// The description of the model, and the size of the binary chunk.
struct Scene {
  std::string json;
  std::size_t binary;
};

Scene describe(const Model& model, const Box& box, const Point& origin) {
  const std::size_t vertices = model.positions.size(), triangles = model.triangles.size();
  Arrays arrays;  // in the order of append_arrays()
  JsonObject attributes, primitive;
  JsonObject bounds;
  bounds.add_json("min", json_point(box.least, origin)).add_json("max", json_point(box.most, origin));
  attributes.add("POSITION", arrays.add(bounds, kFloat, "VEC3", vertices, 12 * vertices, kVertices));
  const std::int64_t indices =
      arrays.add({}, kUnsignedInt, "SCALAR", 3 * triangles, 12 * triangles, kIndices);
  if (!model.colours.empty())
    attributes.add("COLOR_0", arrays.add(JsonObject().add("normalized", true), kUnsignedShort, "VEC4",
                                         vertices, 8 * vertices, kVertices));
  primitive.add_json("attributes", attributes.one_line()).add("indices", indices).add("material", 0);

  JsonObject node;
  node.add("mesh", 0);
  if (origin != Point{})
    node.add_json("translation", json_array({json(origin[0]), json(origin[1]), json(origin[2])}));
  // Neither metal nor gloss: the colours alone.
  const std::string surface = JsonObject().add("metallicFactor", 0).add("roughnessFactor", 1).one_line();

  JsonObject scene;
  scene.add_json("asset", JsonObject().add("version", "2.0").add("generator", "FilmstickingPP").one_line())
      .add("scene", 0)
      .add_json("scenes", json_array({JsonObject().add_json("nodes", "[0]").one_line()}))
      .add_json("nodes", json_array({node.one_line()}))
      .add_json(
          "meshes",
          json_array({JsonObject().add_json("primitives", json_array({primitive.one_line()})).one_line()}))
      .add_json("materials", json_array({JsonObject().add_json("pbrMetallicRoughness", surface).one_line()}))
      .add_json("accessors", arrays.accessors())
      .add_json("bufferViews", arrays.views())
      .add_json(
          "buffers",
          json_array({JsonObject().add("byteLength", static_cast<std::int64_t>(arrays.bytes())).one_line()}));
  return {scene.one_line(), arrays.bytes()};
}

void append_arrays(const Model& model, const Point& origin, ByteWriter& out) {
  for (const Point& p : model.positions)
    out.add([&](std::string& bytes) {
      for (int axis = 0; axis < 3; ++axis) append(bytes, static_cast<float>(p[axis] - origin[axis]));
    });
  for (const Triangle& triangle : model.triangles)
    out.add([&](std::string& bytes) {
      for (const std::int32_t corner : triangle) append(bytes, corner);
    });
  for (const Colour& colour : model.colours)
    out.add([&](std::string& bytes) {
      for (const std::uint8_t channel : colour) append(bytes, to_linear(channel));
      append(bytes, std::uint16_t{65535});
    });
}

}  // namespace

void encode_glb(const Model& model, ByteWriter& out) {
  if (model.triangles.empty()) throw IoError("there are no triangles for it");
  const Box box = box_of(model.positions);
  const Point origin = origin_of(model.positions, box);
  check_range(model.positions, origin);
  Scene scene = describe(model, box, origin);
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
  append_arrays(model, origin, out);
}

}  // namespace filmsticking::io
