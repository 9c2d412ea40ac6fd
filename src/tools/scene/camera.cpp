// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace filmsticking::scene {
namespace {

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Calls `take` for every finite point.
template <typename Take>
void for_finite(const std::vector<std::vector<Point>>& points, Take take) {
  for (const std::vector<Point>& some : points)
    for (const Point& p : some)
      if (std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2])) take(p);
}

}  // namespace

Frame make_frame(const Angles& angles) {
  const double a = angles.azimuth * M_PI / 180, e = angles.elevation * M_PI / 180;
  Frame frame{{std::cos(a), 0, -std::sin(a)},
              {-std::sin(a) * std::sin(e), std::cos(e), -std::cos(a) * std::sin(e)},
              {std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e)}};
  if (angles.z_up)
    for (Point* p : {&frame.right, &frame.up, &frame.out}) *p = {(*p)[0], -(*p)[2], (*p)[1]};
  return frame;
}

Target aim(const std::vector<std::vector<Point>>& points, const std::vector<Frame>& frames) {
  // The box along the directions of a single frame is the tightest; several frames share the upright box.
  const Frame axes = frames.size() == 1 ? frames[0] : Frame{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const auto along = [](const Frame& frame, const Point& p) {
    return Point{dot(p, frame.right), dot(p, frame.up), dot(p, frame.out)};
  };
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Point low{kInfinity, kInfinity, kInfinity}, high{-kInfinity, -kInfinity, -kInfinity};
  for_finite(points, [&](const Point& p) {
    const Point q = along(axes, p);
    for (int k = 0; k < 3; ++k) low[k] = std::min(low[k], q[k]), high[k] = std::max(high[k], q[k]);
  });
  Target target;
  if (!(low[0] <= high[0])) return target;

  Point middle{};
  for (int k = 0; k < 3; ++k) middle[k] = low[k] / 2 + high[k] / 2;
  for (int k = 0; k < 3; ++k)
    target.middle[k] = middle[0] * axes.right[k] + middle[1] * axes.up[k] + middle[2] * axes.out[k];
  if (frames.size() == 1) {
    for (int k = 0; k < 3; ++k) target.half_size[k] = high[k] / 2 - low[k] / 2;
    return target;
  }
  target.half_size = {0, 0, 0};
  for_finite(points, [&](Point p) {
    for (int k = 0; k < 3; ++k) p[k] -= target.middle[k];
    for (const Frame& frame : frames) {
      const Point q = along(frame, p);
      for (int k = 0; k < 3; ++k) target.half_size[k] = std::max(target.half_size[k], std::abs(q[k]));
    }
  });
  return target;
}

vtkSmartPointer<vtkCamera> make_camera(const Target& target, const Frame& frame, double aspect,
                                       const Margins& margins) {
  const double width = target.half_size[0], height = target.half_size[1];
  const double depth = std::max({target.half_size[2], width, height, 1e-30}) * 2;
  const double free_width = 1 - margins.right;
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(std::max({height, width / (aspect * free_width), 1e-30}) * margins.factor);
  camera->SetWindowCenter(margins.right, 0);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(depth * frame.out[0], depth * frame.out[1], depth * frame.out[2]);
  camera->SetViewUp(frame.up.data());
  camera->SetClippingRange(0.25 * depth, 1.75 * depth);
  return camera;
}

}  // namespace filmsticking::scene
