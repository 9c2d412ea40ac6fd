// SPDX-License-Identifier: GPL-3.0-or-later
// What the columns of files stand for, by the names that programs give them: decided here for all formats.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace filmsticking::io {

/// The meaning of a column; Number: the number of the point in its file.
enum class Role : std::uint8_t {
  X,
  Y,
  Z,
  Red,
  Green,
  Blue,
  Alpha,
  PackedColour,
  NormalX,
  NormalY,
  NormalZ,
  ViewpointX,
  ViewpointY,
  ViewpointZ,
  Intensity,
  Number,
  Other
};

/// The name without quotes, units ("x [m]", "Y(mm)") and comment signs ("//X"), in lower case.
std::string plain_name(std::string_view name);

/// The role that a name has in any case and with any unit: "X", "easting" and "Points:0" are x. The roles of
/// colours and normals hold only where all three are there.
Role role_of(std::string_view name);

/// Which of the names of its role this is: those of a triple that belong together, as "nx ny nz", have the
/// same number. What is smaller goes before others.
std::size_t family_of(std::string_view name);

constexpr std::size_t kFamilies = 14;  ///< most names of a role

/// PCL's name of a column with this role: normal_x for nx.
std::string field_name(Role role, const std::string& name);

}  // namespace filmsticking::io
