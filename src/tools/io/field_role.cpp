// SPDX-License-Identifier: GPL-3.0-or-later
#include "field_role.h"

#include <map>

namespace filmsticking::io {
namespace {

// After each writer whose names differ: PCL, CloudCompare, MeshLab, ParaView, COLMAP, trimesh, PDAL, Potree.
const std::map<std::string_view, Role>& roles() {
  static const std::map<std::string_view, Role> names = {
      {"x", Role::X},
      {"y", Role::Y},
      {"z", Role::Z},
      {"easting", Role::X},
      {"northing", Role::Y},
      {"elevation", Role::Z},
      {"height", Role::Z},
      {"points:0", Role::X},
      {"points:1", Role::Y},
      {"points:2", Role::Z},
      {"points_0", Role::X},
      {"points_1", Role::Y},
      {"points_2", Role::Z},
      {"pos_x", Role::X},
      {"pos_y", Role::Y},
      {"pos_z", Role::Z},
      {"position_x", Role::X},
      {"position_y", Role::Y},
      {"position_z", Role::Z},
      {"x_coord", Role::X},
      {"y_coord", Role::Y},
      {"z_coord", Role::Z},
      {"r", Role::Red},
      {"g", Role::Green},
      {"b", Role::Blue},
      {"a", Role::Alpha},
      {"red", Role::Red},
      {"green", Role::Green},
      {"blue", Role::Blue},
      {"alpha", Role::Alpha},
      {"rf", Role::Red},
      {"gf", Role::Green},
      {"bf", Role::Blue},
      {"diffuse_red", Role::Red},
      {"diffuse_green", Role::Green},
      {"diffuse_blue", Role::Blue},
      {"diffuse_alpha", Role::Alpha},
      {"color_r", Role::Red},
      {"color_g", Role::Green},
      {"color_b", Role::Blue},
      {"rgb:0", Role::Red},
      {"rgb:1", Role::Green},
      {"rgb:2", Role::Blue},
      {"rgb_0", Role::Red},
      {"rgb_1", Role::Green},
      {"rgb_2", Role::Blue},
      {"rgb", Role::PackedColour},
      {"rgba", Role::PackedColour},
      {"nx", Role::NormalX},
      {"ny", Role::NormalY},
      {"nz", Role::NormalZ},
      {"normal_x", Role::NormalX},
      {"normal_y", Role::NormalY},
      {"normal_z", Role::NormalZ},
      {"normalx", Role::NormalX},
      {"normaly", Role::NormalY},
      {"normalz", Role::NormalZ},
      {"vp_x", Role::ViewpointX},
      {"vp_y", Role::ViewpointY},
      {"vp_z", Role::ViewpointZ},
      {"intensity", Role::Intensity},
      {"i", Role::Intensity},
      {"id", Role::Number},
      {"index", Role::Number},
      {"idx", Role::Number},
      {"nr", Role::Number},
      {"no", Role::Number},
      {"point_id", Role::Number},
      {"pointid", Role::Number},
      {"point3d_id", Role::Number},
      {"point", Role::Number},
  };
  return names;
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
