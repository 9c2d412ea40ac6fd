// SPDX-License-Identifier: GPL-3.0-or-later
#include "model_file.h"

#include <algorithm>
#include <initializer_list>

#include "files.h"
#include "io_error.h"
#include "obj.h"
#include "pcd.h"
#include "ply.h"
#include "stl.h"
#include "vtk_polydata.h"
#include "xyz.h"

namespace filmsticking::io {
namespace {

using Extensions = std::initializer_list<const char*>;

Model read(const std::string& path, Extensions known) {
  const std::string extension = extension_of(path);
  check_readable(path);
  if (std::find(known.begin(), known.end(), extension) == known.end()) {
    std::string names;
    for (const char* name : known) names += std::string(" ") + name;
    throw IoError("its extension is none of" + names);
  }
  if (extension == ".vtk") return read_vtk(path);
  const std::string bytes = read_file(path);
  if (extension == ".pcd") return decode_pcd(bytes);
  if (extension == ".ply") return decode_ply(bytes);
  if (extension == ".obj") return decode_obj(bytes);
  if (extension == ".stl") return decode_stl(bytes);
  return decode_xyz(bytes);
}

}  // namespace

Model read_cloud(const std::string& path) {
  Model model = read(path, {".pcd", ".ply", ".obj", ".stl", ".xyz", ".txt"});
  if (model.positions.empty()) throw IoError("there are no points in it");
  return model;
}

Model read_mesh(const std::string& path) {
  Model model = read(path, {".ply", ".obj", ".stl", ".vtk"});
  if (model.triangles.empty()) throw IoError("there are no triangles in it");
  return model;
}

Model read_model(const std::string& path) {
  return read(path, {".pcd", ".ply", ".obj", ".stl", ".vtk", ".xyz", ".txt"});
}

bool can_write_model(const std::string& path) {
  const std::string extension = extension_of(path);
  return extension == ".ply" || extension == ".obj" || extension == ".stl" || extension == ".vtk";
}

void write_model(const std::string& path, const Model& model) {
  const std::string extension = extension_of(path);
  if (extension == ".ply") return write_file(path, encode_ply(model));
  if (extension == ".obj") return write_file(path, encode_obj(model));
  if (extension == ".stl") return write_file(path, encode_stl(model));
  if (extension == ".vtk") return write_file(path, encode_vtk(model));
  throw IoError("its extension is none of .ply .obj .stl .vtk");
}

}  // namespace filmsticking::io
