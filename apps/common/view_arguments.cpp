// SPDX-License-Identifier: GPL-3.0-or-later
#include "view_arguments.h"

#include <cmath>
#include <cstdio>
#include <locale>
#include <sstream>

namespace filmsticking::app {
namespace {

/// "A<separator>B" as two numbers.
bool parse_pair(const std::string& text, char separator, double& a, double& b) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  char between = 0;
  return stream >> a >> between >> b && between == separator && stream.peek() == EOF;
}

}  // namespace

void add_view(Arguments& arguments, scene::Angles& angles) {
  arguments.option(
      "--view", "AZ,EL", "degrees: around the upright axis, and above the horizon; default 30,20",
      [&angles](const std::string& text) {
        if (!parse_pair(text, ',', angles.azimuth, angles.elevation) || !std::isfinite(angles.azimuth) ||
            !(std::abs(angles.elevation) <= 90))
          throw UsageError("--view takes two angles in degrees like 30,20, the second from -90 to 90, not '" +
                           text + "'");
      });
  arguments.choice("--up", "y|z", "the upright axis; default y", angles.z_up, {{"y", false}, {"z", true}});
}

void add_size(Arguments& arguments, const std::string& help, int least, int most, int& width, int& height) {
  arguments.option("--size", "WxH", help, [=, &width, &height](const std::string& text) {
    double w = 0, h = 0;
    if (!parse_pair(text, 'x', w, h) || !(w >= least && h >= least && w <= most && h <= most))
      throw UsageError("--size takes pixels like 1200x800, from " + std::to_string(least) + " to " +
                       std::to_string(most) + ", not '" + text + "'");
    width = static_cast<int>(w);
    height = static_cast<int>(h);
  });
}

}  // namespace filmsticking::app
