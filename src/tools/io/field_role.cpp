// SPDX-License-Identifier: GPL-3.0-or-later
#include "field_role.h"

#include <array>
#include <map>

namespace filmsticking::io {
namespace {

struct Names {
  Role role;
  std::array<std::string_view, 7> names;
};

// As PCL, CloudCompare, MeshLab, ParaView, COLMAP, trimesh, PDAL and surveyors' programs write them. Names at
// the same place of a triple belong together; those in front go before others.
constexpr Names kNames[] = {
    {Role::X, {"x", "easting", "points:0", "points_0", "pos_x", "position_x", "x_coord"}},
    {Role::Y, {"y", "northing", "points:1", "points_1", "pos_y", "position_y", "y_coord"}},
    {Role::Z, {"z", "elevation", "points:2", "points_2", "pos_z", "position_z", "z_coord"}},
    {Role::X, {"field.x", "point.x", "position.x", "east", "e", "rechtswert", "pointx"}},
    {Role::Y, {"field.y", "point.y", "position.y", "north", "n", "hochwert", "pointy"}},
    {Role::Z, {"field.z", "point.z", "position.z", "height", "h", "hoehe", "pointz"}},
    {Role::Red, {"red", "r", "rf", "diffuse_red", "color_r", "rgb:0", "rgb_0"}},
    {Role::Green, {"green", "g", "gf", "diffuse_green", "color_g", "rgb:1", "rgb_1"}},
    {Role::Blue, {"blue", "b", "bf", "diffuse_blue", "color_b", "rgb:2", "rgb_2"}},
    {Role::Alpha, {"alpha", "a", "af", "diffuse_alpha", "color_a", "rgb:3", "rgb_3"}},
    {Role::Red, {"color_red", "colorr", "colour_red", "field.r", "vertex_red", "color.r", "r8"}},
    {Role::Green, {"color_green", "colorg", "colour_green", "field.g", "vertex_green", "color.g", "g8"}},
    {Role::Blue, {"color_blue", "colorb", "colour_blue", "field.b", "vertex_blue", "color.b", "b8"}},
    {Role::PackedColour, {"rgb", "rgba", "field.rgb"}},
    {Role::NormalX, {"normal_x", "nx", "normalx", "normals:0", "normals_0", "n_x", "normal.x"}},
    {Role::NormalY, {"normal_y", "ny", "normaly", "normals:1", "normals_1", "n_y", "normal.y"}},
    {Role::NormalZ, {"normal_z", "nz", "normalz", "normals:2", "normals_2", "n_z", "normal.z"}},
    {Role::ViewpointX, {"vp_x"}},
    {Role::ViewpointY, {"vp_y"}},
    {Role::ViewpointZ, {"vp_z"}},
    {Role::Intensity, {"intensity", "i", "field.intensity"}},
    {Role::Number, {"id", "index", "idx", "nr", "no", "point_id", "point3d_id"}},
    {Role::Number, {"pointid", "point"}},
};

struct Meaning {
  Role role = Role::Other;
  std::size_t family = 0;
};

const std::map<std::string_view, Meaning>& meanings() {
  static const std::map<std::string_view, Meaning> by_name = [] {
    std::map<std::string_view, Meaning> all;
    std::map<Role, std::size_t> families;
    for (const Names& names : kNames) {
      std::size_t& family = families[names.role];
      for (const std::string_view name : names.names) {
        if (!name.empty()) all.emplace(name, Meaning{names.role, family});
        ++family;
      }
    }
    return all;
  }();
  return by_name;
}

Meaning meaning_of(std::string_view name) {
  const std::string plain = plain_name(name);
  auto found = meanings().find(plain);
  const std::size_t slash = plain.find('/');  // "X/Easting"
  if (found == meanings().end() && slash != std::string::npos)
    found = meanings().find(plain.substr(0, slash));
  return found == meanings().end() ? Meaning{} : found->second;
}

}  // namespace

std::string plain_name(std::string_view name) {
  constexpr std::string_view kEdge = " \t\"'/#%`,;";
  name = name.substr(0, name.find_first_of("[("));
  const std::size_t begin = name.find_first_not_of(kEdge);
  if (begin == std::string_view::npos) return "";
  std::string plain(name.substr(begin, name.find_last_not_of(kEdge) - begin + 1));
  for (char& c : plain)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return plain;
}

Role role_of(std::string_view name) { return meaning_of(name).role; }

std::size_t family_of(std::string_view name) { return meaning_of(name).family; }

std::string field_name(Role role, const std::string& name) {
  switch (role) {
    case Role::X:
      return "x";
    case Role::Y:
      return "y";
    case Role::Z:
      return "z";
    case Role::NormalX:
      return "normal_x";
    case Role::NormalY:
      return "normal_y";
    case Role::NormalZ:
      return "normal_z";
    case Role::ViewpointX:
      return "vp_x";
    case Role::ViewpointY:
      return "vp_y";
    case Role::ViewpointZ:
      return "vp_z";
    case Role::Intensity:
      return "intensity";
    default:
      return name;
  }
}

}  // namespace filmsticking::io
