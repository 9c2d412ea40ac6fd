// SPDX-License-Identifier: GPL-3.0-or-later
#include "ply.h"

#include <algorithm>
#include <cstring>
#include <map>

#include "faces.h"
#include "float_exact.h"
#include "io_error.h"
#include "scalar.h"
#include "text_scanner.h"

namespace filmsticking::io {
namespace {

enum class Format { Ascii, LittleEndian, BigEndian };

struct Property {
  std::string name;
  Scalar type = Scalar::Float;
  bool is_list = false;
  Scalar count_type = Scalar::UInt8;
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  Format format = Format::Ascii;
  std::vector<Element> elements;
};

Scalar parse_type(std::string_view name) {
  static const std::map<std::string_view, Scalar> types = {
      {"char", Scalar::Int8},     {"int8", Scalar::Int8},     {"uchar", Scalar::UInt8},
      {"uint8", Scalar::UInt8},   {"short", Scalar::Int16},   {"int16", Scalar::Int16},
      {"ushort", Scalar::UInt16}, {"uint16", Scalar::UInt16}, {"int", Scalar::Int32},
      {"int32", Scalar::Int32},   {"uint", Scalar::UInt32},   {"uint32", Scalar::UInt32},
      {"float", Scalar::Float},   {"float32", Scalar::Float}, {"double", Scalar::Double},
      {"float64", Scalar::Double}};
  const auto found = types.find(name);
  if (found == types.end()) throw IoError("its PLY header has an unknown type '" + std::string(name) + "'");
  return found->second;
}

Format parse_format(std::string_view name) {
  if (name == "ascii") return Format::Ascii;
  if (name == "binary_little_endian") return Format::LittleEndian;
  if (name == "binary_big_endian") return Format::BigEndian;
  throw IoError("its PLY header has an unknown format '" + std::string(name) + "'");
}

/// Leaves `file` at the first byte after the header.
Header parse_header(TextScanner& file) {
  Header header;
  std::string_view text;
  if (!file.line(text) || text != "ply") throw IoError("it is not a PLY file");
  while (file.line(text)) {
    TextScanner line(text);
    const std::string_view keyword = line.word();
    if (keyword == "end_header") return header;
    if (keyword == "format") {
      header.format = parse_format(line.word());
    } else if (keyword == "element") {
      Element element;
      element.name = line.word();
      long long count = 0;
      if (!parse_integer(line.word(), count) || count < 0)
        throw IoError("its PLY header has a bad number of '" + element.name + "'");
      element.count = static_cast<std::size_t>(count);
      header.elements.push_back(element);
    } else if (keyword == "property") {
      if (header.elements.empty()) throw IoError("its PLY header has a property before any element");
      Property property;
      std::string_view type = line.word();
      property.is_list = type == "list";
      if (property.is_list) {
        property.count_type = parse_type(line.word());
        type = line.word();
      }
      property.type = parse_type(type);
      property.name = line.word();
      header.elements.back().properties.push_back(property);
    }
  }
  throw IoError("its PLY header has no end");
}

/// The values of the body, one after the other.
class Body {
 public:
  Body(Format format, std::string_view bytes) : format_(format), bytes_(bytes), text_(bytes) {}

  double value(Scalar type) {
    if (format_ == Format::Ascii) return text_value(type);
    char raw[8];
    const std::size_t size = size_of(type);
    if (bytes_.size() < size) throw_short();
    std::memcpy(raw, bytes_.data(), size);
    bytes_.remove_prefix(size);
    if (format_ == Format::BigEndian) std::reverse(raw, raw + size);
    return load(raw, type);
  }

  /// A list's length; a length that the rest of the file cannot hold is refused.
  std::size_t list_size(const Property& list) {
    const double size = value(list.count_type);
    const double smallest = format_ == Format::Ascii ? 1 : static_cast<double>(size_of(list.type));
    if (!(size >= 0)) throw IoError("a list in it has a negative length");
    if (size * smallest > static_cast<double>(remaining())) throw_short();
    return static_cast<std::size_t>(size);
  }

  /// Refuses an element with more rows than the rest of the file can hold.
  void check_room(const Element& element) {
    std::size_t smallest = 0;
    for (const Property& property : element.properties)
      smallest +=
          format_ == Format::Ascii ? 1 : size_of(property.is_list ? property.count_type : property.type);
    if (element.count > remaining() / std::max<std::size_t>(smallest, 1)) throw_short();
  }

 private:
  std::size_t remaining() const { return format_ == Format::Ascii ? text_.remaining() : bytes_.size(); }

  double text_value(Scalar type) {
    float single = 0;
    double value = 0;
    if (!(type == Scalar::Float ? text_.number(single) : text_.number(value))) {
      if (text_.remaining() == 0) throw_short();
      throw IoError("its body has a word that is not a number");
    }
    return type == Scalar::Float ? static_cast<double>(single) : value;
  }

  [[noreturn]] static void throw_short() { throw IoError("it ends before its PLY header says"); }

  Format format_;
  std::string_view bytes_;
  TextScanner text_;
};

void read_vertices(Body& body, const Element& element, Model& model) {
  enum Role { X, Y, Z, Red, Green, Blue, kRoles, Other = kRoles };
  static const std::map<std::string_view, Role> roles = {{"x", X},
                                                         {"y", Y},
                                                         {"z", Z},
                                                         {"red", Red},
                                                         {"green", Green},
                                                         {"blue", Blue},
                                                         {"diffuse_red", Red},
                                                         {"diffuse_green", Green},
                                                         {"diffuse_blue", Blue}};
  std::vector<Role> role_of;
  bool has[kRoles] = {};
  for (const Property& property : element.properties) {
    const auto found = roles.find(property.name);
    Role role = found == roles.end() || property.is_list ? Other : found->second;
    if (role >= Red && role <= Blue && property.type != Scalar::UInt8) role = Other;
    role_of.push_back(role);
    if (role != Other) has[role] = true;
  }
  if (!has[X] || !has[Y] || !has[Z]) throw IoError("its vertices have no x, y and z");
  const bool coloured = has[Red] && has[Green] && has[Blue];

  model.positions.reserve(element.count);
  if (coloured) model.colours.reserve(element.count);
  for (std::size_t row = 0; row < element.count; ++row) {
    double values[kRoles + 1] = {};
    for (std::size_t k = 0; k < role_of.size(); ++k) {
      const Property& property = element.properties[k];
      const std::size_t repeats = property.is_list ? body.list_size(property) : 1;
      for (std::size_t r = 0; r < repeats; ++r) values[role_of[k]] = body.value(property.type);
    }
    model.positions.push_back({values[X], values[Y], values[Z]});
    if (coloured) {
      const auto byte = [&](Role role) {
        if (!(values[role] >= 0 && values[role] <= 255)) throw IoError("a colour in it is not from 0 to 255");
        return static_cast<std::uint8_t>(values[role]);
      };
      model.colours.push_back({byte(Red), byte(Green), byte(Blue)});
    }
  }
}

/// That there are such vertices is seen at the end: faces may come first.
void read_faces(Body& body, const Element& element, Model& model) {
  std::vector<std::int32_t> corners;
  for (std::size_t row = 0; row < element.count; ++row)
    for (const Property& property : element.properties) {
      const bool is_face =
          property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index");
      const std::size_t repeats = property.is_list ? body.list_size(property) : 1;
      corners.clear();
      for (std::size_t r = 0; r < repeats; ++r) {
        const double value = body.value(property.type);
        if (is_face) corners.push_back(corner_index(value));
      }
      append_polygon(corners, model);
    }
}

void skip(Body& body, const Element& element) {
  for (std::size_t row = 0; row < element.count; ++row)
    for (const Property& property : element.properties) {
      const std::size_t repeats = property.is_list ? body.list_size(property) : 1;
      for (std::size_t r = 0; r < repeats; ++r) body.value(property.type);
    }
}

}  // namespace

Model decode_ply(std::string_view bytes) {
  TextScanner file(bytes);
  const Header header = parse_header(file);
  Body body(header.format, bytes.substr(bytes.size() - file.remaining()));

  Model model;
  for (const Element& element : header.elements) {
    if (element.properties.empty()) continue;
    body.check_room(element);
    if (element.name == "vertex" && model.positions.empty()) {
      read_vertices(body, element, model);
    } else if (element.name == "face") {
      read_faces(body, element, model);
    } else {
      skip(body, element);
    }
  }
  check_corners(model);
  return model;
}

void encode_ply(const Model& model, ByteWriter& out) {
  const bool single = float_exact(model.positions);
  const char* type = single ? "float" : "double";
  std::string header =
      "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(model.positions.size()) + "\n";
  for (const char* axis : {"x", "y", "z"}) header += std::string("property ") + type + " " + axis + "\n";
  if (!model.colours.empty())
    for (const char* channel : {"red", "green", "blue"})
      header += std::string("property uchar ") + channel + "\n";
  if (!model.triangles.empty())
    header += "element face " + std::to_string(model.triangles.size()) +
              "\nproperty list uchar int vertex_indices\n";
  out.append(header + "end_header\n");

  for (std::size_t i = 0; i < model.positions.size(); ++i)
    out.add([&](std::string& bytes) {
      for (const double x : model.positions[i]) {
        if (single) {
          append(bytes, static_cast<float>(x));
        } else {
          append(bytes, x);
        }
      }
      if (!model.colours.empty())
        for (const std::uint8_t channel : model.colours[i]) append(bytes, channel);
    });
  for (const Triangle& triangle : model.triangles)
    out.add([&](std::string& bytes) {
      append(bytes, std::uint8_t{3});
      for (const std::int32_t corner : triangle) append(bytes, corner);
    });
}

}  // namespace filmsticking::io
