// SPDX-License-Identifier: GPL-3.0-or-later
#include "stl.h"

#include <cmath>
#include <set>
#include <vector>

#include "float_exact.h"
#include "io_error.h"
#include "number_text.h"
#include "scalar.h"
#include "text_scanner.h"

namespace filmsticking::io {
namespace {

/// Zero for a triangle without area.
Point unit_normal(const Point& a, const Point& b, const Point& c) {
  const Point u{b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  const Point v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  Point n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  const double length = std::hypot(n[0], n[1], n[2]);
  for (double& x : n) x = length > 0 ? x / length : 0;
  return n;
}

void encode_binary(const Model& model, ByteWriter& out) {
  out.append(std::string(80, '\0'));
  out.add([&](std::string& bytes) { append(bytes, static_cast<std::uint32_t>(model.triangles.size())); });
  for (const Triangle& t : model.triangles)
    out.add([&](std::string& bytes) {
      const Point corners[3] = {model.positions[t[0]], model.positions[t[1]], model.positions[t[2]]};
      for (const double x : unit_normal(corners[0], corners[1], corners[2]))
        append(bytes, static_cast<float>(x));
      for (const Point& corner : corners)
        for (const double x : corner) append(bytes, static_cast<float>(x));
      append(bytes, std::uint16_t{0});
    });
}

void append_point(std::string& text, const Point& p) {
  for (const double x : p) {
    text += ' ';
    append_number(text, x);
  }
  text += '\n';
}

void encode_text(const Model& model, ByteWriter& out) {
  out.append("solid\n");
  for (const Triangle& t : model.triangles)
    out.add([&](std::string& text) {
      const Point corners[3] = {model.positions[t[0]], model.positions[t[1]], model.positions[t[2]]};
      text += "facet normal";
      append_point(text, unit_normal(corners[0], corners[1], corners[2]));
      text += "outer loop\n";
      for (const Point& corner : corners) {
        text += "vertex";
        append_point(text, corner);
      }
      text += "endloop\nendfacet\n";
    });
  out.append("endsolid\n");
}

/// Puts triangles together from their corners; equal corners become one vertex.
class CornerJoiner {
 public:
  CornerJoiner() = default;
  CornerJoiner(const CornerJoiner&) = delete;
  CornerJoiner& operator=(const CornerJoiner&) = delete;

  void add(const Point& corner) {
    const auto next = static_cast<std::int32_t>(model_.positions.size());
    model_.positions.push_back(corner);
    const auto [found, is_new] = vertices_.insert(next);
    if (!is_new) model_.positions.pop_back();
    triangle_[corners_++ % 3] = *found;
    if (corners_ % 3 == 0) model_.triangles.push_back(triangle_);
  }

  Model take() {
    if (corners_ == 0 || corners_ % 3 != 0) throw IoError("it is not a whole STL file");
    return std::move(model_);
  }

 private:
  Model model_;
  // By position, which they share with the model: no second copy of the points.
  struct Before {
    const std::vector<Point>& positions;
    bool operator()(std::int32_t a, std::int32_t b) const { return positions[a] < positions[b]; }
  };
  std::set<std::int32_t, Before> vertices_{Before{model_.positions}};
  Triangle triangle_{};
  std::size_t corners_ = 0;
};

bool is_finite(const Point& p) { return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]); }

Model decode_binary(std::string_view bytes) {
  CornerJoiner joiner;
  for (std::size_t facet = 84; facet + 50 <= bytes.size(); facet += 50)
    for (std::size_t k = 0; k < 3; ++k) {
      const char* corner = bytes.data() + facet + 12 + 12 * k;
      const Point p{load<float>(corner), load<float>(corner + 4), load<float>(corner + 8)};
      if (!is_finite(p)) throw IoError("a corner in it is not finite");
      joiner.add(p);
    }
  return joiner.take();
}

Model decode_text(std::string_view bytes) {
  CornerJoiner joiner;
  TextScanner text(bytes);
  bool ended = false;
  for (std::string_view word = text.word(); !word.empty(); word = text.word()) {
    if (word == "endsolid") ended = true;
    if (word != "vertex") continue;
    ended = false;
    Point p{};
    for (double& x : p)
      if (!text.number(x)) throw IoError("it is not a whole STL file");
    if (!is_finite(p)) throw IoError("a corner in it is not finite");
    joiner.add(p);
  }
  if (!ended) throw IoError("it is not a whole STL file");
  return joiner.take();
}

}  // namespace

Model decode_stl(std::string_view bytes) {
  // A text begins with "solid", but so do some binary files: their size tells. Others have more at their end.
  const std::size_t size =
      bytes.size() < 84 ? 84 : 84 + std::size_t{50} * load<std::uint32_t>(bytes.data() + 80);
  if (bytes.size() == size) return decode_binary(bytes);
  if (bytes.substr(0, 5) == "solid") return decode_text(bytes);
  if (bytes.size() > size) return decode_binary(bytes.substr(0, size));
  throw IoError("it is not a whole STL file");
}

void encode_stl(const Model& model, ByteWriter& out) {
  if (float_exact(model.positions)) {
    encode_binary(model, out);
  } else {
    encode_text(model, out);
  }
}

}  // namespace filmsticking::io
