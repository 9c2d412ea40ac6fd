// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats.h"

#include <algorithm>
#include <utility>

#include "codecs.h"
#include "files.h"
#include "io_error.h"
#include "text_scanner.h"

namespace filmsticking::io {
namespace {

bool begins_with(std::string_view bytes, std::string_view magic) {
  return bytes.substr(0, magic.size()) == magic;
}

/// Binary STL has no magic, but its length follows from its number of triangles.
bool is_binary_stl(std::string_view bytes) {
  constexpr std::size_t kHeader = 80, kTriangle = 50;
  return bytes.size() >= kHeader + 4 &&
         bytes.size() == kHeader + 4 + kTriangle * std::size_t{load<std::uint32_t>(bytes.data() + kHeader)};
}

/// By the first line of text that is not a comment: "pcd" (a header may begin with comments), "obj", "xyz" or
/// nothing.
std::string detect_text(std::string_view bytes) {
  TextScanner file(bytes);
  for (std::string_view text; file.line(text);) {
    TextScanner line(text);
    const std::string_view word = line.word();
    if (word == "VERSION" || word == "FIELDS") return "pcd";
    if (word.empty() || word[0] == '#' || begins_with(word, "//")) continue;
    for (const char* keyword : {"v", "vn", "vt", "f", "o", "g", "mtllib", "usemtl", "s"})
      if (word == keyword) return "obj";
    double number = 0;
    TextScanner again(text);
    return again.number(number) ? "xyz" : "";
  }
  return "";
}

[[noreturn]] void throw_no_vertex() { throw IoError("a face in it names a vertex that does not exist"); }

struct Format {
  const char* name;
  bool reads_cloud, reads_mesh, writes_mesh;
};
constexpr Format kFormats[] = {
    {"pcd", true, false, false}, {"ply", true, true, true},   {"obj", true, true, true},
    {"stl", true, true, true},   {"vtk", false, true, true},  {"xyz", true, false, false},
    {"txt", true, false, false}, {"glb", false, false, true},
};

template <class Wanted>
std::vector<std::string> formats_where(Wanted wanted) {
  std::vector<std::string> names;
  for (const Format& format : kFormats)
    if (wanted(format)) names.push_back(format.name);
  return names;
}

/// The path's extension without its dot, if it is one of the formats.
std::string format_of(const std::string& path, const std::vector<std::string>& formats) {
  const std::string extension = extension_of(path);
  for (const std::string& format : formats)
    if (extension == "." + format) return format;
  throw IoError("its extension is none of " + extensions_of(formats));
}

}  // namespace

const std::vector<std::string>& cloud_formats() {
  static const std::vector<std::string> formats =
      formats_where([](const Format& format) { return format.reads_cloud; });
  return formats;
}

const std::vector<std::string>& mesh_formats() {
  static const std::vector<std::string> formats =
      formats_where([](const Format& format) { return format.writes_mesh; });
  return formats;
}

std::string extensions_of(const std::vector<std::string>& formats) {
  std::string text;
  for (const std::string& format : formats) text += (text.empty() ? "." : " .") + format;
  return text;
}

std::string detect_format(std::string_view bytes) {
  if (begins_with(bytes, "ply\n") || begins_with(bytes, "ply\r")) return "ply";
  if (begins_with(bytes, "# .PCD")) return "pcd";
  if (is_binary_stl(bytes) || begins_with(bytes, "solid")) return "stl";
  return detect_text(bytes);
}

Cloud decode_cloud(const std::string& format, std::string_view bytes) {
  Cloud cloud = format == "pcd"                      ? decode_pcd(bytes)
                : format == "xyz" || format == "txt" ? decode_xyz(bytes)
                                                     : Cloud{decode_mesh(format, bytes).cloud};
  cloud.viewpoints = viewpoints_of(cloud.points);
  return cloud;
}

pcl::PolygonMesh decode_mesh(const std::string& format, std::string_view bytes) {
  if (format == "ply") return decode_ply(bytes);
  if (format == "obj") return decode_obj(bytes);
  if (format == "stl") return decode_stl(bytes);
  if (format == "vtk") return decode_vtk(bytes);
  if (format == "pcd" || format == "xyz" || format == "txt")
    return make_mesh(format == "pcd" ? decode_pcd(bytes).points : decode_xyz(bytes).points, {});
  throw IoError("there is no format '" + format + "' for points");
}

void encode_mesh(const std::string& format, const pcl::PCLPointCloud2& vertices,
                 const std::vector<Triangle>& triangles, const ByteSink& sink) {
  ByteWriter out(sink);
  if (format == "ply") {
    encode_ply(vertices, triangles, out);
  } else if (format == "obj") {
    encode_obj(vertices, triangles, out);
  } else if (format == "stl") {
    encode_stl(vertices, triangles, out);
  } else if (format == "vtk") {
    encode_vtk(vertices, triangles, out);
  } else if (format == "glb") {
    encode_glb(vertices, triangles, out);
  } else {
    throw IoError("there is no format '" + format + "' for meshes");
  }
  out.flush();
}

std::string encode_mesh(const std::string& format, const pcl::PolygonMesh& mesh) {
  std::string bytes;
  encode_mesh(format, mesh.cloud, triangles_of(mesh.polygons),
              [&](std::string_view piece) { bytes += piece; });
  return bytes;
}

Cloud read_cloud(const std::string& path, std::int64_t most) {
  check_readable(path, most);
  const std::string format = format_of(path, cloud_formats());
  Cloud cloud = decode_cloud(format, read_file(path, most));
  if (size_of(cloud.points) == 0) throw IoError("there are no points in it");
  return cloud;
}

pcl::PolygonMesh read_mesh(const std::string& path) {
  check_readable(path);
  const std::string format = format_of(path, formats_where([](const Format& f) { return f.reads_mesh; }));
  pcl::PolygonMesh mesh = decode_mesh(format, read_file(path));
  if (mesh.polygons.empty()) throw IoError("there are no triangles in it");
  return mesh;
}

pcl::PolygonMesh read_model(const std::string& path) {
  check_readable(path);
  const std::string format =
      format_of(path, formats_where([](const Format& f) { return f.reads_cloud || f.reads_mesh; }));
  return decode_mesh(format, read_file(path));
}

bool can_write_mesh(const std::string& path) {
  const std::vector<std::string>& formats = mesh_formats();
  const std::string extension = extension_of(path);
  return std::any_of(formats.begin(), formats.end(),
                     [&](const std::string& format) { return extension == "." + format; });
}

void write_mesh(const std::string& path, const pcl::PCLPointCloud2& vertices,
                const std::vector<Triangle>& triangles) {
  const std::string format = format_of(path, mesh_formats());
  write_file(path, [&](const ByteSink& sink) { encode_mesh(format, vertices, triangles, sink); });
}

void write_mesh(const std::string& path, const pcl::PolygonMesh& mesh) {
  write_mesh(path, mesh.cloud, triangles_of(mesh.polygons));
}

void throw_no_number(std::string_view file, std::string_view word) {
  constexpr std::size_t kShown = 30;
  std::string shown(word.substr(0, kShown));
  for (char& c : shown)
    if (c < ' ' || c > '~') c = '?';
  throw IoError("line " +
                std::to_string(line_number(file, static_cast<std::size_t>(word.data() - file.data()))) +
                ": '" + shown + (word.size() > kShown ? ".." : "") + "' is no number of its column's type");
}

void append_polygon(const std::vector<std::int32_t>& corners, std::vector<Triangle>& triangles) {
  for (std::size_t k = 2; k < corners.size(); ++k)
    triangles.push_back({corners[0], corners[k - 1], corners[k]});
}

std::int32_t corner_index(double value) {
  if (!(value >= 0 && value < INT32_MAX)) throw_no_vertex();
  return static_cast<std::int32_t>(value);
}

void check_corners(const std::vector<Triangle>& triangles, std::size_t vertices) {
  for (const Triangle& triangle : triangles)
    for (const std::int32_t corner : triangle)
      if (static_cast<std::size_t>(corner) >= vertices) throw_no_vertex();
}

}  // namespace filmsticking::io
