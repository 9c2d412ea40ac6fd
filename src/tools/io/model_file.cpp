// SPDX-License-Identifier: GPL-3.0-or-later
#include "model_file.h"

#include <algorithm>
#include <vector>

#include "files.h"
#include "format.h"
#include "io_error.h"

namespace filmsticking::io {
namespace {

std::string dotted(const std::vector<std::string>& formats) {
  std::string names;
  for (const std::string& format : formats) names += " ." + format;
  return names;
}

/// The path's extension without its dot, if it is one of the formats.
std::string format_of(const std::string& path, const std::vector<std::string>& formats) {
  const std::string extension = extension_of(path);
  for (const std::string& format : formats)
    if (extension == "." + format) return format;
  throw IoError("its extension is none of" + dotted(formats));
}

Model read(const std::string& path, const std::vector<std::string>& formats, std::int64_t most = 0) {
  check_readable(path, most);
  const std::string format = format_of(path, formats);
  return decode_cloud(format, read_file(path, most));
}

}  // namespace

Model read_cloud(const std::string& path, std::int64_t most) {
  Model model = read(path, cloud_formats(), most);
  if (model.positions.empty()) throw IoError("there are no points in it");
  return model;
}

Model read_mesh(const std::string& path) {
  Model model = read(path, {"ply", "obj", "stl", "vtk"});
  if (model.triangles.empty()) throw IoError("there are no triangles in it");
  return model;
}

Model read_model(const std::string& path) {
  return read(path, {"pcd", "ply", "obj", "stl", "vtk", "xyz", "txt"});
}

bool can_write_model(const std::string& path) {
  const std::vector<std::string>& formats = mesh_formats();
  const std::string extension = extension_of(path);
  return std::any_of(formats.begin(), formats.end(),
                     [&](const std::string& format) { return extension == "." + format; });
}

void write_model(const std::string& path, const Model& model) {
  const std::string format = format_of(path, mesh_formats());
  write_file(path, [&](const ByteSink& sink) { encode_model(format, model, sink); });
}

}  // namespace filmsticking::io
