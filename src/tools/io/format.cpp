// SPDX-License-Identifier: GPL-3.0-or-later
#include "format.h"

#include <cstdint>
#include <utility>

#include "glb.h"
#include "io_error.h"
#include "obj.h"
#include "pcd.h"
#include "ply.h"
#include "scalar.h"
#include "stl.h"
#include "text_scanner.h"
#include "vtk.h"
#include "xyz.h"

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

}  // namespace

const std::vector<std::string>& cloud_formats() {
  static const std::vector<std::string> formats = {"pcd", "ply", "obj", "stl", "xyz", "txt"};
  return formats;
}

const std::vector<std::string>& mesh_formats() {
  static const std::vector<std::string> formats = {"ply", "obj", "stl", "vtk", "glb"};
  return formats;
}

std::string detect_format(std::string_view bytes) {
  if (begins_with(bytes, "ply\n") || begins_with(bytes, "ply\r")) return "ply";
  if (begins_with(bytes, "# .PCD")) return "pcd";
  if (is_binary_stl(bytes) || begins_with(bytes, "solid")) return "stl";
  return detect_text(bytes);
}

Model decode_cloud(const std::string& format, std::string_view bytes) {
  if (format == "pcd") return decode_pcd(bytes);
  if (format == "ply") return decode_ply(bytes);
  if (format == "obj") return decode_obj(bytes);
  if (format == "stl") return decode_stl(bytes);
  if (format == "vtk") return decode_vtk(bytes);
  if (format == "xyz" || format == "txt") return decode_xyz(bytes);
  throw IoError("there is no format '" + format + "' for points");
}

Model decode_cloud(const std::string& format, std::string&& bytes) {
  std::string held = std::move(bytes);
  if (format == "pcd") return decode_pcd(held, [&held] { std::string().swap(held); });
  return decode_cloud(format, std::string_view(held));
}

void encode_model(const std::string& format, const Model& model, const ByteSink& sink) {
  ByteWriter out(sink);
  if (format == "ply") {
    encode_ply(model, out);
  } else if (format == "obj") {
    encode_obj(model, out);
  } else if (format == "stl") {
    encode_stl(model, out);
  } else if (format == "vtk") {
    encode_vtk(model, out);
  } else if (format == "glb") {
    encode_glb(model, out);
  } else {
    throw IoError("there is no format '" + format + "' for meshes");
  }
  out.flush();
}

std::string encode_model(const std::string& format, const Model& model) {
  std::string bytes;
  encode_model(format, model, [&](std::string_view piece) { bytes += piece; });
  return bytes;
}

}  // namespace filmsticking::io
