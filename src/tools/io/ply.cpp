// SPDX-License-Identifier: GPL-3.0-or-later
// By hand: PCL's reader drops fields and reads double coordinates as zeros, CGAL's drops all but positions.
#include <algorithm>
#include <cstring>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "codecs.h"
#include "io_error.h"
#include "text_scanner.h"

namespace filmsticking::io {
namespace {

enum class PlyFormat { Ascii, LittleEndian, BigEndian };

struct Property {
  std::string name;
  Scalar type = Scalar::Float;
  bool is_list = false;
  Scalar count_type = Scalar::UInt8;
  std::optional<std::size_t> offset = std::nullopt;  // of its bytes in a point; none: it is skipped
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::Ascii;
  std::vector<Element> elements;
};

constexpr std::pair<const char*, const char*> kNormals[] = {
    {"nx", "normal_x"}, {"ny", "normal_y"}, {"nz", "normal_z"}};  // PLY's names and PCL's

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

const char* type_name(Scalar type) {
  constexpr const char* kNames[] = {"",     "char",  "uchar",  "short",  "ushort", "int",
                                    "uint", "float", "double", "double", "double"};
  return kNames[static_cast<std::size_t>(type)];
}

PlyFormat parse_format(std::string_view name) {
  if (name == "ascii") return PlyFormat::Ascii;
  if (name == "binary_little_endian") return PlyFormat::LittleEndian;
  if (name == "binary_big_endian") return PlyFormat::BigEndian;
  throw IoError("its PLY header has an unknown format '" + std::string(name) + "'");
}

Element parse_element(TextScanner& line) {
  Element element;
  element.name = line.word();
  long long count = 0;
  if (!parse_integer(line.word(), count) || count < 0)
    throw IoError("its PLY header has a bad number of '" + element.name + "'");
  element.count = static_cast<std::size_t>(count);
  return element;
}

Property parse_property(TextScanner& line) {
  Property property;
  std::string_view type = line.word();
  property.is_list = type == "list";
  if (property.is_list) {
    property.count_type = parse_type(line.word());
    type = line.word();
  }
  property.type = parse_type(type);
  property.name = line.word();
  return property;
}

/// Leaves `file` at the first byte after the header.
PlyHeader parse_ply_header(TextScanner& file) {
  PlyHeader header;
  std::string_view text;
  if (!file.line(text) || text != "ply") throw IoError("it is not a PLY file");
  while (file.line(text)) {
    TextScanner line(text);
    const std::string_view keyword = line.word();
    if (keyword == "end_header") return header;
    if (keyword == "format") {
      header.format = parse_format(line.word());
    } else if (keyword == "element") {
      header.elements.push_back(parse_element(line));
    } else if (keyword == "property") {
      if (header.elements.empty()) throw IoError("its PLY header has a property before any element");
      header.elements.back().properties.push_back(parse_property(line));
    }
  }
  throw IoError("its PLY header has no end");
}

/// The values of the body, one after the other.
class Body {
 public:
  Body(PlyFormat format, std::string_view bytes) : format_(format), bytes_(bytes), text_(bytes) {}

  /// Puts the next number to `to` as its type's bytes.
  void take(Scalar type, void* to) {
    if (format_ == PlyFormat::Ascii) return take_text(type, to);
    const std::size_t size = size_of(type);
    if (bytes_.size() < size) throw_short();
    std::memcpy(to, bytes_.data(), size);
    bytes_.remove_prefix(size);
    if (format_ == PlyFormat::BigEndian) std::reverse(static_cast<char*>(to), static_cast<char*>(to) + size);
  }

  double value(Scalar type) {
    char raw[8];
    take(type, raw);
    return load(raw, type);
  }

  /// A list's length; a length that the rest of the file cannot hold is refused.
  std::size_t list_size(const Property& list) {
    const double size = value(list.count_type);
    const double smallest = format_ == PlyFormat::Ascii ? 1 : static_cast<double>(size_of(list.type));
    if (!(size >= 0)) throw IoError("a list in it has a negative length");
    if (size * smallest > static_cast<double>(remaining())) throw_short();
    return static_cast<std::size_t>(size);
  }

  /// Skips a property, however long its list is.
  void skip(const Property& property) {
    const std::size_t repeats = property.is_list ? list_size(property) : 1;
    for (std::size_t r = 0; r < repeats; ++r) value(property.type);
  }

  /// Refuses an element with more rows than the rest of the file can hold.
  void check_count(const Element& element) {
    std::size_t smallest = 0;
    for (const Property& property : element.properties)
      smallest +=
          format_ == PlyFormat::Ascii ? 1 : size_of(property.is_list ? property.count_type : property.type);
    if (element.count > remaining() / std::max<std::size_t>(smallest, 1)) throw_short();
  }

 private:
  std::size_t remaining() const { return format_ == PlyFormat::Ascii ? text_.remaining() : bytes_.size(); }

  void take_text(Scalar type, void* to) {
    const std::string_view word = text_.word();
    if (word.empty()) throw_short();
    if (!store_number(word, type, to)) throw IoError("its body has a word that is no number of its type");
  }

  [[noreturn]] static void throw_short() { throw IoError("it ends before its PLY header says"); }

  PlyFormat format_;
  std::string_view bytes_;
  TextScanner text_;
};

/// Where a byte property goes in PCL's packed colour: blue, green, red, alpha. None if it is no colour.
std::optional<std::size_t> place_in_colour(const Property& property) {
  static const std::map<std::string_view, std::size_t> places = {
      {"blue", 0},         {"green", 1},         {"red", 2},         {"alpha", 3},
      {"diffuse_blue", 0}, {"diffuse_green", 1}, {"diffuse_red", 2}, {"diffuse_alpha", 3}};
  const auto found = places.find(property.name);
  if (found == places.end() || property.is_list || property.type != Scalar::UInt8) return std::nullopt;
  return found->second;
}

/// PCL's name of a property.
std::string field_name(const std::string& name) {
  for (const auto& [ply, pcl] : kNormals)
    if (name == ply) return pcl;
  return name;
}

/// Gives the properties of the vertices their places in a point, and the points their fields: x, y, z, then
/// all others in the order of the file.
class Layout {
 public:
  explicit Layout(Element& vertices) : vertices_(vertices) {
    bool channels[4] = {};
    for (const Property& property : vertices.properties)
      if (const auto place = place_in_colour(property)) channels[*place] = true;
    coloured_ = channels[0] && channels[1] && channels[2];
    alpha_ = channels[3];
    for (const char* axis : {"x", "y", "z"})
      for (Property& property : vertices.properties)
        if (property.name == axis) add(property);
    if (fields_.size() != 3) throw IoError("its vertices have no x, y and z");
    for (Property& property : vertices.properties) add(property);
  }

  pcl::PCLPointCloud2 cloud() const {
    pcl::PCLPointCloud2 cloud = make_rows(fields_, step_, vertices_.count);
    if (coloured_ && !alpha_)
      for (std::size_t at = *colour_ + 3; at < cloud.data.size(); at += step_) cloud.data[at] = 255;
    return cloud;
  }

 private:
  void add(Property& property) {
    if (property.is_list || property.offset) return;
    if (const auto place = place_in_colour(property); place && coloured_) {
      if (!colour_) colour_ = alpha_ ? add_field("rgba", Scalar::UInt32) : add_field("rgb", Scalar::Float);
      property.offset = *colour_ + *place;
      return;
    }
    const std::string name = field_name(property.name);
    const bool known = std::any_of(fields_.begin(), fields_.end(),
                                   [&](const pcl::PCLPointField& field) { return field.name == name; });
    if (!known) property.offset = add_field(name, property.type);
  }

  std::size_t add_field(const std::string& name, Scalar type) {
    const std::size_t offset = step_;
    fields_.push_back(make_field(name, offset, static_cast<std::uint8_t>(type)));
    step_ += size_of(type);
    return offset;
  }

  Element& vertices_;
  std::vector<pcl::PCLPointField> fields_;
  std::size_t step_ = 0;
  std::optional<std::size_t> colour_;
  bool coloured_ = false, alpha_ = false;
};

pcl::PCLPointCloud2 read_vertices(Body& body, Element& element) {
  pcl::PCLPointCloud2 cloud = Layout(element).cloud();
  std::uint8_t* point = cloud.data.data();
  for (std::size_t row = 0; row < element.count; ++row, point += cloud.point_step)
    for (const Property& property : element.properties)
      property.offset ? body.take(property.type, point + *property.offset) : body.skip(property);
  return with_real_positions(std::move(cloud));
}

/// That there are such vertices is seen at the end: faces may come first.
void read_faces(Body& body, const Element& element, std::vector<Triangle>& triangles) {
  std::vector<std::int32_t> corners;
  for (std::size_t row = 0; row < element.count; ++row)
    for (const Property& property : element.properties) {
      if (!property.is_list || (property.name != "vertex_indices" && property.name != "vertex_index")) {
        body.skip(property);
        continue;
      }
      corners.resize(body.list_size(property));
      for (std::int32_t& corner : corners) corner = corner_index(body.value(property.type));
      append_polygon(corners, triangles);
    }
}

/// A property that encode_ply() writes.
struct Column {
  std::string name;
  Scalar type;
  std::size_t offset;  // in a point
};

/// The columns of a field. x, y, z, and the padding that PCD files name "_", have none.
std::vector<Column> columns_of(const pcl::PCLPointField& field) {
  const auto type = static_cast<Scalar>(field.datatype);
  if (field.name == "x" || field.name == "y" || field.name == "z" || field.name == "_") return {};
  if ((field.name == "rgb" || field.name == "rgba") && size_of(type) == 4) {
    std::vector<Column> channels = {{"red", Scalar::UInt8, field.offset + 2UL},
                                    {"green", Scalar::UInt8, field.offset + 1UL},
                                    {"blue", Scalar::UInt8, field.offset}};
    if (field.name == "rgba") channels.push_back({"alpha", Scalar::UInt8, field.offset + 3UL});
    return channels;
  }
  std::string name = field.name;
  for (const auto& [ply, pcl] : kNormals)
    if (name == pcl) name = ply;
  for (char& c : name)
    if (std::strchr(" \t\r\n\v\f,;", c)) c = '_';
  if (name.empty() || size_of(type) == 0) return {};
  if (field.count <= 1) return {{name, type, field.offset}};
  std::vector<Column> columns;
  for (std::size_t k = 0; k < field.count; ++k)
    columns.push_back({name + "_" + std::to_string(k), type, field.offset + k * size_of(type)});
  return columns;
}

/// The columns of all fields. No name occurs twice; the packed colour has the names of colours.
std::vector<Column> columns_of(const pcl::PCLPointCloud2& cloud) {
  const pcl::PCLPointField* colour = find_field(cloud, "rgb");
  if (!colour) colour = find_field(cloud, "rgba");
  std::set<std::string> taken;
  if (colour)
    for (const Column& column : columns_of(*colour)) taken.insert(column.name);
  std::vector<Column> columns;
  for (const pcl::PCLPointField& field : cloud.fields)
    for (const Column& column : columns_of(field))
      if (&field == colour || taken.insert(column.name).second) columns.push_back(column);
  return columns;
}

}  // namespace

pcl::PolygonMesh decode_ply(std::string_view bytes) {
  TextScanner file(bytes);
  PlyHeader header = parse_ply_header(file);
  Body body(header.format, bytes.substr(bytes.size() - file.remaining()));

  pcl::PCLPointCloud2 vertices = make_cloud({});
  std::vector<Triangle> triangles;
  for (Element& element : header.elements) {
    if (element.properties.empty()) continue;
    body.check_count(element);
    if (element.name == "vertex" && size_of(vertices) == 0) {
      vertices = read_vertices(body, element);
    } else if (element.name == "face") {
      read_faces(body, element, triangles);
    } else {
      for (std::size_t row = 0; row < element.count; ++row)
        for (const Property& property : element.properties) body.skip(property);
    }
  }
  check_corners(triangles, size_of(vertices));
  return make_mesh(std::move(vertices), triangles);
}

void encode_ply(const pcl::PCLPointCloud2& vertices, const std::vector<Triangle>& triangles,
                ByteWriter& out) {
  const PositionFields positions(vertices);
  const bool single = float_exact(vertices);
  const std::vector<Column> columns = columns_of(vertices);
  std::string header =
      "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(size_of(vertices)) + "\n";
  const auto add_property = [&header](const char* type, const std::string& name) {
    header.append("property ").append(type).append(" ").append(name).append("\n");
  };
  for (const char* axis : {"x", "y", "z"}) add_property(single ? "float" : "double", axis);
  for (const Column& column : columns) add_property(type_name(column.type), column.name);
  if (!triangles.empty())
    header +=
        "element face " + std::to_string(triangles.size()) + "\nproperty list uchar int vertex_indices\n";
  out.append(header + "end_header\n");

  for (std::size_t i = 0; i < size_of(vertices); ++i)
    out.add([&](std::string& bytes) {
      const std::uint8_t* point = bytes_of(vertices, i);
      for (const double x : positions.load(point))
        single ? append(bytes, static_cast<float>(x)) : append(bytes, x);
      for (const Column& column : columns) {
        const auto* value = reinterpret_cast<const char*>(point) + column.offset;
        if (column.type == Scalar::Int64 || column.type == Scalar::UInt64) {
          append(bytes, load(value, column.type));
        } else {
          bytes.append(value, size_of(column.type));
        }
      }
    });
  for (const Triangle& triangle : triangles)
    out.add([&](std::string& bytes) {
      append(bytes, std::uint8_t{3});
      for (const std::int32_t corner : triangle) append(bytes, corner);
    });
}

}  // namespace filmsticking::io
