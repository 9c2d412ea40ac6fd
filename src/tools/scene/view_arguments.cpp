// SPDX-License-Identifier: GPL-3.0-or-later
#include "view_arguments.h"

#include <cmath>
#include <cstdio>
#include <locale>
#include <sstream>

#include "common/usage_error.h"

namespace filmsticking::scene {
namespace {

/// "A<separator>B" as two numbers.
bool parse_pair(const std::string& text, char separator, double& a, double& b) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  char between = 0;
  return stream >> a >> between >> b && between == separator && stream.peek() == EOF;
}

}  // namespace

void parse_view(const std::string& text, Angles& angles) {
  if (!parse_pair(text, ',', angles.azimuth, angles.elevation) || !std::isfinite(angles.azimuth) ||
      !(std::abs(angles.elevation) <= 90))
    throw app::UsageError("--view takes two angles in degrees like 30,20, the second from -90 to 90");
}

void parse_up(const std::string& text, Angles& angles) {
  if (text != "y" && text != "z") throw app::UsageError("--up takes y or z");
  angles.z_up = text == "z";
}

void parse_size(const std::string& text, int least, int most, int& width, int& height) {
  double w = 0, h = 0;
  if (!parse_pair(text, 'x', w, h) || !(w >= least && h >= least && w <= most && h <= most))
    throw app::UsageError("--size takes pixels like 1200x800, from " + std::to_string(least) + " to " +
                          std::to_string(most));
  width = static_cast<int>(w);
  height = static_cast<int>(h);
}

}  // namespace filmsticking::scene
