// SPDX-License-Identifier: GPL-3.0-or-later
// By hand: PCL's reader drops fields and reads double coordinates as zeros, CGAL's drops all but positions.
#include <algorithm>
#include <cstring>
#include <map>
#include <set>
#include <string>

#include "codecs.h"
#include "field_role.h"
#include "io_error.h"
#include "point_layout.h"
#include "text_scanner.h"

namespace filmsticking::io {
namespace {

enum class PlyFormat { Ascii, LittleEndian, BigEndian };

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

struct PlyHeader {
  PlyFormat format = PlyFormat::Ascii;
  std::vector<Element> elements;
};

constexpr std::pair<const char*, const char*> kNormals[] = {
    {"nx", "normal_x"}, {"ny", "normal_y"}, {"nz", "normal_z"}};  // PLY's names and PCL's

Scalar parse_type(std::string_view name) {
  static const std::map<std::string_view, Scalar> types = {
      {"char", Scalar::Int8},      {"int8", Scalar::Int8},     {"uchar", Scalar::UInt8},
      {"uint8", Scalar::UInt8},    {"short", Scalar::Int16},   {"int16", Scalar::Int16},
      {"ushort", Scalar::UInt16},  {"uint16", Scalar::UInt16}, {"int", Scalar::Int32},
      {"int32", Scalar::Int32},    {"uint", Scalar::UInt32},   {"uint32", Scalar::UInt32},
      {"float", Scalar::Float},    {"float32", Scalar::Float}, {"double", Scalar::Double},
      {"float64", Scalar::Double}, {"int64", Scalar::Int64},   {"uint64", Scalar::UInt64},
      {"long", Scalar::Int64},     {"ulong", Scalar::UInt64}};
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
  if (!file.line(text) || TextScanner(text).word() != "ply") throw IoError("it is not a PLY file");
  while (file.line(text)) {
    TextScanner line(text, TextScanner::kBlanks);
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
  /// `file` has the body from byte `begin` on.
  Body(PlyFormat format, std::string_view file, std::size_t begin)
      : format_(format), file_(file), bytes_(file.substr(begin)), text_(bytes_, TextScanner::kBlanks) {}

  PlyFormat format() const { return format_; }

  /// The bytes of an element without lists.
  std::string_view take_bytes(const Element& element) {
    std::size_t size = 0;
    for (const Property& property : element.properties) size += size_of(property.type);
    const std::string_view bytes = bytes_.substr(0, size * element.count);  // check_count() saw them
    bytes_.remove_prefix(bytes.size());
    return bytes;
  }

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

  /// Refuses a text with more numbers than its header says, as all of them may be of other points. In a
  /// binary file they are noted.
  void check_end(Notes& notes) {
    constexpr std::size_t kSmall = 12;  // bytes, fewer than a point has
    if (format_ == PlyFormat::Ascii && !text_.word().empty())
      throw IoError("it has more numbers than its PLY header says; correct the header");
    if (format_ != PlyFormat::Ascii && bytes_.size() >= kSmall)
      notes.push_back("left out " + std::to_string(bytes_.size()) + " bytes behind its last element");
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
    if (!store_number(word, type, to)) throw_no_number(file_, word);
  }

  [[noreturn]] static void throw_short() { throw IoError("it ends before its PLY header says"); }

  PlyFormat format_;
  std::string_view file_, bytes_;
  TextScanner text_;
};

/// Values of Gaussians, not of points on a surface; SuperSplat's packed ones lack x, y and z.
void refuse_splats(const PlyHeader& header) {
  for (const Element& element : header.elements)
    for (const Property& property : element.properties)
      if (property.name == "f_dc_0" || property.name == "packed_position")
        throw IoError(
            "it has Gaussian splats, whose centres are no points of a surface; convert it with 3dgsconverter "
            "(-f cc), and read what that writes");
}

pcl::PCLPointCloud2 read_vertices(Body& body, const Element& element, Notes& notes) {
  std::vector<Column> columns;
  std::vector<std::size_t> column_of(element.properties.size());
  bool lists = false;
  for (std::size_t k = 0; k < element.properties.size(); ++k) {
    const Property& property = element.properties[k];
    column_of[k] = columns.size();
    lists |= property.is_list;
    if (!property.is_list) columns.push_back({property.name, property.type});
  }
  const PointLayout layout(columns);
  if (body.format() != PlyFormat::Ascii && !lists)
    return layout.read(body.take_bytes(element), element.count, body.format() == PlyFormat::BigEndian, notes);
  pcl::PCLPointCloud2 cloud = layout.cloud(element.count);
  std::uint8_t* point = cloud.data.data();
  for (std::size_t row = 0; row < element.count; ++row, point += cloud.point_step)
    for (std::size_t k = 0; k < element.properties.size(); ++k) {
      const Property& property = element.properties[k];
      const std::size_t offset = property.is_list ? PointLayout::kNowhere : layout.offset(column_of[k]);
      offset == PointLayout::kNowhere ? body.skip(property) : body.take(property.type, point + offset);
    }
  layout.finish(cloud, notes);
  if (lists) notes.push_back("the lists of its vertices are left out");
  return cloud;
}

/// That there are such vertices is seen at the end: faces may come first.
void read_faces(Body& body, const Element& element, Shape& shape) {
  std::vector<std::int32_t> corners;
  for (const Property& property : element.properties)
    if (role_of(property.name) == Role::Red) shape.notes.push_back("left out the colours of its faces");
  for (std::size_t row = 0; row < element.count; ++row)
    for (const Property& property : element.properties) {
      if (!property.is_list || (property.name != "vertex_indices" && property.name != "vertex_index")) {
        body.skip(property);
        continue;
      }
      corners.resize(body.list_size(property));
      for (std::int32_t& corner : corners) corner = corner_index(body.value(property.type));
      append_polygon(corners, shape.triangles);
    }
}

/// A property that encode_ply() writes.
struct Written {
  std::string name;
  Scalar type;
  std::size_t offset;  // in a point
};

/// The columns of a field. x, y, z, and the padding that PCD files name "_", have none.
std::vector<Written> written_of(const pcl::PCLPointField& field) {
  const auto type = static_cast<Scalar>(field.datatype);
  if (field.name == "x" || field.name == "y" || field.name == "z" || field.name == "_") return {};
  if (is_station(field.name)) return {};  // a mesh is seen from anywhere
  if ((field.name == "rgb" || field.name == "rgba") && size_of(type) == 4) {
    std::vector<Written> channels = {{"red", Scalar::UInt8, field.offset + 2UL},
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
  std::vector<Written> columns;
  for (std::size_t k = 0; k < field.count; ++k)
    columns.push_back({name + "_" + std::to_string(k), type, field.offset + k * size_of(type)});
  return columns;
}

/// The columns of all fields. No name occurs twice; the packed colour has the names of colours.
std::vector<Written> written_of(const pcl::PCLPointCloud2& cloud) {
  const pcl::PCLPointField* colour = find_field(cloud, "rgb");
  if (!colour) colour = find_field(cloud, "rgba");
  std::set<std::string> taken;
  if (colour)
    for (const Written& column : written_of(*colour)) taken.insert(column.name);
  std::vector<Written> columns;
  for (const pcl::PCLPointField& field : cloud.fields)
    for (const Written& column : written_of(field))
      if (&field == colour || taken.insert(column.name).second) columns.push_back(column);
  return columns;
}

}  // namespace

Shape decode_ply(std::string_view bytes) {
  TextScanner file(bytes);
  const PlyHeader header = parse_ply_header(file);
  refuse_splats(header);
  Body body(header.format, bytes, bytes.size() - file.remaining());
  Shape shape{make_cloud({})};
  for (const Element& element : header.elements) {
    if (element.properties.empty()) continue;
    body.check_count(element);
    if (element.name == "vertex" && size_of(shape.points) == 0) {
      shape.points = read_vertices(body, element, shape.notes);
    } else if (element.name == "face") {
      read_faces(body, element, shape);
    } else {
      for (std::size_t row = 0; row < element.count; ++row)
        for (const Property& property : element.properties) body.skip(property);
    }
  }
  body.check_end(shape.notes);
  check_corners(shape.triangles, size_of(shape.points));
  return shape;
}

void encode_ply(const pcl::PCLPointCloud2& vertices, const std::vector<Triangle>& triangles,
                ByteWriter& out) {
  const PositionFields positions(vertices);
  const bool single = float_exact(vertices);
  const std::vector<Written> columns = written_of(vertices);
  std::string header =
      "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(size_of(vertices)) + "\n";
  const auto add_property = [&header](const char* type, const std::string& name) {
    header.append("property ").append(type).append(" ").append(name).append("\n");
  };
  for (const char* axis : {"x", "y", "z"}) add_property(single ? "float" : "double", axis);
  for (const Written& column : columns) add_property(type_name(column.type), column.name);
  if (!triangles.empty())
    header +=
        "element face " + std::to_string(triangles.size()) + "\nproperty list uchar int vertex_indices\n";
  out.append(header + "end_header\n");

  for (std::size_t i = 0; i < size_of(vertices); ++i)
    out.add([&](std::string& bytes) {
      const std::uint8_t* point = bytes_of(vertices, i);
      for (const double x : positions.load(point))
        single ? append(bytes, static_cast<float>(x)) : append(bytes, x);
      for (const Written& column : columns) {
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
