// SPDX-License-Identifier: GPL-3.0-or-later
#include "cloud_spec.h"

#include <sstream>
#include <stdexcept>

namespace filmsticking::bench {

const char* name_of(Sampling sampling) {
  switch (sampling) {
    case Sampling::MonteCarlo:
      return "monte-carlo";
    case Sampling::PoissonDisk:
      return "poisson-disk";
    case Sampling::MixedDensity:
      return "mixed-density";
    case Sampling::Vertices:
      return "vertices";
    case Sampling::DepthView:
      return "depth-view";
    case Sampling::DepthFrame:
      return "depth-frame";
  }
  return "monte-carlo";
}

Sampling sampling_of(const std::string& name) {
  std::string names;
  for (const Sampling s : {Sampling::MonteCarlo, Sampling::PoissonDisk, Sampling::MixedDensity,
                           Sampling::Vertices, Sampling::DepthView, Sampling::DepthFrame}) {
    if (name == name_of(s)) return s;
    names += std::string(names.empty() ? "" : ", ") + name_of(s);
  }
  throw std::invalid_argument("\"" + name + "\" is no sampling; there are " + names);
}

std::string CloudSpec::kind() const {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << name_of(sampling);
  if (noise.deviation > 0) text << " noise " << noise.deviation << (noise.in_spacings ? "s" : "");
  if (outliers > 0) text << " outliers " << outliers;
  if (missing > 0) text << " missing " << missing;
  return text.str();
}

}  // namespace filmsticking::bench
