// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "filters/filter_options.h"
#include "frame.h"
#include "io/model.h"

namespace filmsticking::capture {

/// The finite points of a frame with their colours, behind the filters. Throws CaptureError, also where none
/// is left.
io::Model frame_points(const Frame& frame, const filters::FilterOptions& filters);

/// Moves points from the sensor's coordinates to the world's.
io::Model moved(io::Model points, const Pose& pose);

/// Mean distance from a point to the nearest other; zero if there are fewer than two. Of large clouds, a
/// sample is taken.
double mean_spacing(const io::Model& points);

}  // namespace filmsticking::capture
