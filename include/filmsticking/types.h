// SPDX-License-Identifier: GPL-3.0-or-later
// The plain types that cross the library's border.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace filmsticking {

/// A position: x, y, z in the caller's unit.
using Point = std::array<double, 3>;

/// Points where they lie, in a caller's array of any stride, or some of them by index: nothing is copied.
/// Holds pointers, so what it was made of must outlive it unchanged.
class PointsView {
 public:
  /// All of a vector: a vector is a view of itself.
  PointsView(const std::vector<Point>& points)
      : first_(reinterpret_cast<const char*>(points.data())), stride_(sizeof(Point)), size_(points.size()) {}

  /// `size` points, each of three floats x, y, z in a row, `stride` bytes from the one before.
  PointsView(const float* first, std::size_t stride, std::size_t size)
      : first_(reinterpret_cast<const char*>(first)), stride_(stride), size_(size), floats_(true) {}

  /// The same with doubles.
  PointsView(const double* first, std::size_t stride, std::size_t size)
      : first_(reinterpret_cast<const char*>(first)), stride_(stride), size_(size) {}

  /// Point i is point ids[i] of this view; each must be one of its points. Not more than twice.
  PointsView at(const std::vector<std::int32_t>& ids) const {
    PointsView some = *this;
    some.inner_ids_ = ids_, some.ids_ = ids.data(), some.size_ = ids.size();
    return some;
  }

  std::size_t size() const { return size_; }  ///< how many points
  bool empty() const { return size_ == 0; }   ///< is there none?

  /// Point i, less than size(); floats become doubles, which changes no number.
  Point operator[](std::size_t i) const {
    if (ids_ != nullptr) i = static_cast<std::size_t>(ids_[i]);
    if (inner_ids_ != nullptr) i = static_cast<std::size_t>(inner_ids_[i]);
    const char* place = first_ + i * stride_;  // its bytes: a stride need not be a multiple of a number's
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
  const std::int32_t* ids_ = nullptr;        // or null: all, as they come
  const std::int32_t* inner_ids_ = nullptr;  // of the view that this is some of
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
