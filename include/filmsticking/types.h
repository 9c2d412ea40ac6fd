// SPDX-License-Identifier: GPL-3.0-or-later
// The plain types of the public interface.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace filmsticking {

/// A position: x, y, z in the caller's unit.
using Point = std::array<double, 3>;

/// A view of points in a caller's array of any stride, or of some of them by index. Copies nothing, so the
/// array and the indices must outlive it unchanged.
class PointsView {
 public:
  /// All points of a vector; implicit, so that a vector can be passed as a view.
  PointsView(const std::vector<Point>& points)
      : first_(reinterpret_cast<const char*>(points.data())), stride_(sizeof(Point)), size_(points.size()) {}

  /// `size` points of three consecutive floats x, y, z, each `stride` bytes after the one before.
  PointsView(const float* first, std::size_t stride, std::size_t size)
      : first_(reinterpret_cast<const char*>(first)), stride_(stride), size_(size), floats_(true) {}

  /// The same with doubles.
  PointsView(const double* first, std::size_t stride, std::size_t size)
      : first_(reinterpret_cast<const char*>(first)), stride_(stride), size_(size) {}

  /// The view whose point i is point ids[i] of this view; ids must be below size(). Can be applied twice at
  /// most.
  PointsView at(const std::vector<std::int32_t>& ids) const {
    PointsView some = *this;
    some.inner_ids_ = ids_, some.ids_ = ids.data(), some.size_ = ids.size();
    return some;
  }

  std::size_t size() const { return size_; }  ///< how many points
  bool empty() const { return size_ == 0; }   ///< is there none?

  /// Point i; i < size(). Floats are converted to doubles exactly.
  Point operator[](std::size_t i) const {
    if (ids_ != nullptr) i = static_cast<std::size_t>(ids_[i]);
    if (inner_ids_ != nullptr) i = static_cast<std::size_t>(inner_ids_[i]);
    const char* place = first_ + i * stride_;  // by bytes: a stride may be any number of them
    if (floats_) {
      std::array<float, 3> p;
      std::memcpy(p.data(), place, sizeof p);
      return {p[0], p[1], p[2]};
    }
    Point p;
    std::memcpy(p.data(), place, sizeof p);
    return p;
  }

 private:
  const char* first_;
  std::size_t stride_;
  std::size_t size_;
  const std::int32_t* ids_ = nullptr;        // null: all, in order
  const std::int32_t* inner_ids_ = nullptr;  // ids of the view that at() was called on
  bool floats_ = false;
};

/// Three vertex indices, counter-clockwise seen from outside.
using Triangle = std::array<std::int32_t, 3>;

/// An indexed triangle mesh.
struct Mesh {
  std::vector<Point> positions;     ///< of the vertices
  std::vector<Triangle> triangles;  ///< indices into `positions`
};

}  // namespace filmsticking
