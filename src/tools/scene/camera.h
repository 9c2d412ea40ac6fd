// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkCamera.h>
#include <vtkSmartPointer.h>

#include <vector>

#include "filmsticking/types.h"

namespace filmsticking::scene {

/// Direction of the camera.
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

/// The smallest target that contains all finite points in each of the frames. One frame is centred; several
/// share a middle, so that the pictures of a turn do not jump.
Target aim(const std::vector<std::vector<Point>>& points, const std::vector<Frame>& frames);

/// The part of a picture that the scene leaves free, for a scale bar or a text.
struct Margins {
  double factor = 1.06;  ///< size of the view, in sizes of the target
  double right = 0;      ///< free share of the width, at the right
};

/// A camera with parallel projection for a scene whose `target.middle` was moved to the origin: large
/// coordinates keep their digits in single precision. `aspect`: width over height of the picture.
vtkSmartPointer<vtkCamera> make_camera(const Target& target, const Frame& frame, double aspect,
                                       const Margins& margins);

}  // namespace filmsticking::scene
