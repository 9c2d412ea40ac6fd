// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkCamera.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "filmsticking/types.h"

namespace filmsticking::scene {

/// From where a picture is taken.
struct Angles {
  double azimuth = 30;    ///< degrees around the upright axis
  double elevation = 20;  ///< degrees above the horizon
  bool z_up = false;      ///< the upright axis is z, else y
};

/// The directions of a picture: to the right, up, and out of it towards the camera; orthonormal.
struct Frame {
  Point right, up, out;
};

Frame make_frame(const Angles& angles);

/// What a camera aims at: a box around `middle` along the directions of a frame.
struct Target {
  Point middle = {0, 0, 0};
  Point half_size = {0.5, 0.5, 0.5};  ///< to the right, up, out
};

/// The smallest target that holds the finite ones of all points, seen by each of the frames in turn. One
/// frame is centred; several share a middle, so that nothing jumps from one to the next.
Target aim(const std::vector<const std::vector<Point>*>& points, const std::vector<Frame>& frames);

/// Where the part of a picture for the scene ends, the rest being for a scale bar or a text.
struct Margins {
  double factor = 1.06;  ///< how much more than the target is seen
  double right = 0;      ///< share of the width that stays free at the right
};

/// A camera with parallel projection for a scene whose `target.middle` was moved to the origin: large
/// coordinates keep their digits in single precision. `aspect`: width over height of the picture.
vtkSmartPointer<vtkCamera> make_camera(const Target& target, const Frame& frame, double aspect,
                                       const Margins& margins);

}  // namespace filmsticking::scene
