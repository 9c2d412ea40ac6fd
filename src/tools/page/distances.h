// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "report/surface.h"

namespace filmsticking::page {

/// For each face the largest distance of its corners and its middle to the truth, in the mesh's unit.
std::vector<double> faces_to_truth(const mesh_report::Surface& mesh, const mesh_report::Surface& truth);

/// The same to the nearest of the points.
std::vector<double> faces_to_points(const mesh_report::Surface& mesh,
                                    const std::vector<mesh_report::Vec3>& points);

/// Distances as colours and as a histogram.
struct Painting {
  std::string title;
  std::vector<std::uint8_t> colours;  ///< 0: none, 255: the scale's length or more
  nlohmann::ordered_json facts() const;

  double length = 1;  ///< of the scale: mesh_report::scale_length()
  double mean = 0, largest = 0;
  std::vector<std::int64_t> bins;  ///< of equal width, up to `length`
  std::int64_t beyond = 0;
};

Painting paint(std::string title, const std::vector<double>& distances);

}  // namespace filmsticking::page
