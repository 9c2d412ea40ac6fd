// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats.h"

#include <algorithm>
#include <utility>

#include "codecs.h"
#include "files.h"
#include "io_error.h"
#include "no_return.h"
#include "refused_formats.h"
#include "text_scanner.h"
#include "text_table.h"

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

bool is_off(std::string_view word) {
  return word.size() >= 3 && word.size() <= 6 && word.substr(word.size() - 3) == "OFF" &&
         word.find_first_not_of("STCN4nOF") == std::string_view::npos;
}

bool begins_with_two_numbers(std::string_view text) {
  TextScanner line(text);
  double number = 0;
  int numbers = 0;
  for (std::string_view word = line.word(); !word.empty() && numbers < 2; word = line.word()) {
    while (!word.empty() && std::string_view("\"'[({").find(word[0]) != std::string_view::npos)
      word.remove_prefix(1);
    while (!word.empty() && std::string_view("\"'])}").find(word.back()) != std::string_view::npos)
      word.remove_suffix(1);
    numbers += parse_number(word, number) ? 1 : 0;
  }
  return numbers == 2;
}

/// By the first line of text that is not a comment, or else by a line with numbers.
std::string detect_text(std::string_view bytes) {
  constexpr std::size_t kMost = 1 << 16;
  std::string buffer;
  std::string_view text;
  try {
    text = plain_text(bytes.substr(0, kMost), buffer);
  } catch (const IoError&) {
    return "";
  }
  if (is_ptx(text)) return "ptx";
  Lines lines(text);
  bool first = true;
  for (std::string_view line; lines.next(line);) {
    TextScanner words(line);
    const std::string_view word = words.word();
    if (word == "VERSION" || word == "FIELDS" || word == "COLUMNS") return "pcd";
    if (is_comment(line) || word.empty()) continue;
    if (first) {
      if (is_off(word)) return "off";
      for (const char* keyword : {"v", "vn", "vt", "vp", "f", "o", "g", "mtllib", "usemtl", "s"})
        if (word == keyword) return "obj";
      if (lower(word) == "ncols" || lower(word) == "nrows") return "grid";
    }
    first = false;
    if (begins_with_two_numbers(line)) return "xyz";
  }
  return "";
}

bool is_table(const std::string& format) {
  for (const char* name : {"xyz", "txt", "csv", "asc", "pts"})
    if (format == name) return true;
  return false;
}

[[noreturn]] void throw_no_vertex() { throw IoError("a face in it names a vertex that does not exist"); }

struct Format {
  const char* name;
  bool reads_cloud, reads_mesh, writes_mesh, writes_cloud;
};
constexpr Format kFormats[] = {
    {"pcd", true, false, false, true},  {"ply", true, true, true, true},
    {"obj", true, true, true, false},   {"stl", true, true, true, false},
    {"vtk", true, true, true, false},   {"off", true, true, false, false},
    {"las", true, false, false, false}, {"ptx", true, false, false, false},
    {"pts", true, false, false, false}, {"xyz", true, false, false, true},
    {"txt", true, false, false, true},  {"csv", true, false, false, false},
    {"asc", true, false, false, false}, {"grid", true, false, false, false},
    {"glb", false, false, true, false},
};

template <class Wanted>
std::vector<std::string> formats_where(Wanted wanted) {
  std::vector<std::string> names;
  for (const Format& format : kFormats)
    if (wanted(format)) names.push_back(format.name);
  return names;
}

bool has_extension_of(const std::string& path, const std::vector<std::string>& formats) {
  const std::string extension = extension_of(path);
  return std::any_of(formats.begin(), formats.end(),
                     [&](const std::string& format) { return extension == "." + format; });
}

/// The format of a file's content; else that of its extension, which then says what is wrong.
std::string content_format(const std::string& extension, std::string_view bytes) {
  refuse_unread_formats(bytes, "");
  std::string found = detect_format(bytes);
  if (!found.empty()) return found;
  refuse_unread_formats(bytes, extension);
  for (const std::string& format : cloud_formats())
    if (extension == "." + format) return format;
  std::string list;
  for (const std::string& format : cloud_formats()) list += " " + format;
  throw IoError("its content is of no format that is read:" + list);
}

Shape decode_shape(const std::string& format, std::string_view bytes) {
  if (format == "ply") return decode_ply(bytes);
  if (format == "obj") return decode_obj(bytes);
  if (format == "stl") return decode_stl(bytes);
  if (format == "vtk") return decode_vtk(bytes);
  if (format == "off") return decode_off(bytes);
  throw IoError("there is no format '" + format + "' for points");
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

const std::vector<std::string>& written_cloud_formats() {
  static const std::vector<std::string> formats =
      formats_where([](const Format& format) { return format.writes_cloud; });
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
  for (const char* first_line : {"ply\n", "ply\r", "ply ", "ply\t"})
    if (begins_with(bytes, first_line)) return "ply";
  if (begins_with(bytes, "# .PCD")) return "pcd";
  if (begins_with(bytes, "LASF")) return "las";
  if (lower(bytes.substr(0, 14)) == "# vtk datafile") return "vtk";
  if (is_binary_stl(bytes) || begins_with(bytes, "solid")) return "stl";
  return detect_text(bytes);
}

Cloud decode_cloud(const std::string& format, std::string_view bytes,
                   const std::vector<std::string>& columns) {
  if (!columns.empty() && !is_table(format))
    throw IoError("its columns have names of their own; --columns is for tables as text");
  Cloud cloud;
  if (format == "pcd") {
    cloud = decode_pcd(bytes);
  } else if (format == "las") {
    cloud = decode_las(bytes);
  } else if (format == "ptx") {
    cloud = decode_ptx(bytes);
  } else if (format == "grid") {
    cloud = decode_grid(bytes);
  } else if (is_table(format)) {
    cloud = decode_xyz(bytes, columns);
  } else {
    Shape shape = decode_shape(format, bytes);
    cloud.points = std::move(shape.points);
    cloud.notes = std::move(shape.notes);
  }
  cloud.viewpoints = viewpoints_of(cloud.points);
  return cloud;
}

pcl::PolygonMesh decode_mesh(const std::string& format, std::string_view bytes, Notes* notes) {
  const bool meshes = std::any_of(std::begin(kFormats), std::end(kFormats), [&](const Format& known) {
    return known.reads_mesh && format == known.name;
  });
  if (!meshes) {
    Cloud cloud = decode_cloud(format, bytes);
    if (notes) *notes = std::move(cloud.notes);
    return make_mesh(std::move(cloud.points), {});
  }
  Shape shape = decode_shape(format, bytes);
  if (notes) *notes = std::move(shape.notes);
  return make_mesh(std::move(shape.points), shape.triangles);
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

Cloud decode_any(std::string_view bytes, const std::string& extension, const ReadOptions& options) {
  const std::string format = options.format.empty() ? content_format(extension, bytes) : options.format;
  const bool other = !options.columns.empty() && options.columns_of_texts_only && !is_table(format);
  Cloud cloud = decode_cloud(format, bytes, other ? std::vector<std::string>{} : options.columns);
  if (other) cloud.notes.push_back("its columns have names of their own, and --columns is not used");
  if (size_of(cloud.points) == 0) throw IoError("there are no points in it");
  if (const std::size_t missing = mark_missing_heights(cloud.points); missing > 0)
    cloud.notes.push_back("left out " + std::to_string(missing) + " points without a height");
  return cloud;
}

Cloud read_cloud(const std::string& path, const ReadOptions& options) {
  const std::string bytes = read_file(path, options.most);
  return decode_any(bytes, extension_of(path), options);
}

pcl::PolygonMesh read_mesh(const std::string& path) {
  pcl::PolygonMesh mesh = read_model(path);
  if (mesh.polygons.empty()) throw IoError("there are no triangles in it");
  return mesh;
}

pcl::PolygonMesh read_model(const std::string& path) {
  const std::string bytes = read_file(path);
  return decode_mesh(content_format(extension_of(path), bytes), bytes);
}

bool can_write_mesh(const std::string& path) { return has_extension_of(path, mesh_formats()); }

void write_mesh(const std::string& path, const pcl::PCLPointCloud2& vertices,
                const std::vector<Triangle>& triangles) {
  const std::string format = format_of(path, mesh_formats());
  write_file(path, [&](const ByteSink& sink) { encode_mesh(format, vertices, triangles, sink); });
}

void write_mesh(const std::string& path, const pcl::PolygonMesh& mesh) {
  write_mesh(path, mesh.cloud, triangles_of(mesh.polygons));
}

bool can_write_cloud(const std::string& path) { return has_extension_of(path, written_cloud_formats()); }

void write_cloud(const std::string& path, const Cloud& cloud) {
  const std::string format = format_of(path, written_cloud_formats());
  write_file(path, [&](const ByteSink& sink) {
    ByteWriter out(sink);
    if (format == "pcd") {
      encode_pcd(cloud, out);
    } else if (format == "ply") {
      encode_ply(cloud.points, {}, out);
    } else {
      encode_xyz(cloud, out);
    }
    out.flush();
  });
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
