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

// As PCL, CloudCompare, MeshLab, ParaView, COLMAP, trimesh, PDAL and surveyors' programs write them.
constexpr Names kNames[] = {
    {Role::X, {"x", "easting", "points:0", "points_0", "pos_x", "position_x", "x_coord"}},
    {Role::Y, {"y", "northing", "points:1", "points_1", "pos_y", "position_y", "y_coord"}},
    {Role::Z, {"z", "elevation", "points:2", "points_2", "pos_z", "position_z", "z_coord"}},
    {Role::Z, {"height"}},
    {Role::Red, {"r", "red", "rf", "diffuse_red", "color_r", "rgb:0", "rgb_0"}},
    {Role::Green, {"g", "green", "gf", "diffuse_green", "color_g", "rgb:1", "rgb_1"}},
    {Role::Blue, {"b", "blue", "bf", "diffuse_blue", "color_b", "rgb:2", "rgb_2"}},
    {Role::Alpha, {"a", "alpha", "diffuse_alpha"}},
    {Role::PackedColour, {"rgb", "rgba"}},
    {Role::NormalX, {"nx", "normal_x", "normalx"}},
    {Role::NormalY, {"ny", "normal_y", "normaly"}},
    {Role::NormalZ, {"nz", "normal_z", "normalz"}},
    {Role::ViewpointX, {"vp_x"}},
    {Role::ViewpointY, {"vp_y"}},
    {Role::ViewpointZ, {"vp_z"}},
    {Role::Intensity, {"intensity", "i"}},
    {Role::Number, {"id", "index", "idx", "nr", "no", "point_id", "point3d_id"}},
    {Role::Number, {"pointid", "point"}},
};

const std::map<std::string_view, Role>& roles() {
  static const std::map<std::string_view, Role> by_name = [] {
    std::map<std::string_view, Role> all;
    for (const Names& names : kNames)
      for (const std::string_view name : names.names)
        if (!name.empty()) all.emplace(name, names.role);
    return all;
  }();
  return by_name;
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

Role role_of(std::string_view name) {
  const auto found = roles().find(plain_name(name));
  return found == roles().end() ? Role::Other : found->second;
}

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
