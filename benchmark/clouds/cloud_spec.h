// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace filmsticking::bench {

enum class Sampling {
  MonteCarlo,    ///< uniform by area
  PoissonDisk,   ///< blue noise by sample elimination
  MixedDensity,  ///< blue noise, Monte Carlo and sparse regular in thirds
  Vertices,      ///< the vertices of the mesh itself, all of them
  DepthView,     ///< the pixels of a depth camera that looks from one side
  DepthFrame,    ///< the same in the camera's frame: it is at the origin and looks along z
};

/// The name on the command line; never null.
const char* name_of(Sampling sampling);

/// Throws std::invalid_argument, whose what() lists the names.
Sampling sampling_of(const std::string& name);

/// Whether a depth camera makes the points.
inline bool is_depth(Sampling sampling) {
  return sampling == Sampling::DepthView || sampling == Sampling::DepthFrame;
}

/// Gaussian, along each axis.
struct Noise {
  double deviation = 0;
  bool in_spacings =
      false;  ///< of sqrt(area / points) of what is sampled; else of the diagonal of the mesh's box
};

/// How a cloud is made from a mesh. The same values give the same points.
struct CloudSpec {
  Sampling sampling = Sampling::MonteCarlo;
  std::int64_t points = 10000;  ///< in all, outliers included; at least 1; of no meaning for vertices
  std::uint64_t seed = 1;
  Noise noise;
  double outliers = 0;  ///< share of the points that are uniform in that box instead, 0 to 1
  double missing = 0;   ///< share of the surface that is not sampled, in round patches, 0 to 0.9

  /// Like "monte-carlo", followed by the disturbances, like "monte-carlo noise 0.005".
  std::string kind() const;
};

}  // namespace filmsticking::bench
