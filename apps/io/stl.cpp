// SPDX-License-Identifier: GPL-3.0-or-later
#include "stl.h"

#include <cmath>
#include <cstring>

#include "float_exact.h"
#include "number_text.h"

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

/// The bytes of a little-endian number.
template <typename T>
void append(std::string& bytes, T value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof value);
}

std::string encode_binary(const Model& model) {
  std::string bytes(80, '\0');
  append(bytes, static_cast<std::uint32_t>(model.triangles.size()));
  for (const Triangle& t : model.triangles) {
    const Point corners[3] = {model.positions[t[0]], model.positions[t[1]], model.positions[t[2]]};
    for (const double x : unit_normal(corners[0], corners[1], corners[2]))
      append(bytes, static_cast<float>(x));
    for (const Point& corner : corners)
      for (const double x : corner) append(bytes, static_cast<float>(x));
    append(bytes, std::uint16_t{0});
  }
  return bytes;
}

void append_point(std::string& text, const Point& p) {
  for (const double x : p) {
    text += ' ';
    append_number(text, x);
  }
  text += '\n';
}

std::string encode_text(const Model& model) {
  std::string text = "solid\n";
  for (const Triangle& t : model.triangles) {
    const Point corners[3] = {model.positions[t[0]], model.positions[t[1]], model.positions[t[2]]};
    text += "facet normal";
    append_point(text, unit_normal(corners[0], corners[1], corners[2]));
    text += "outer loop\n";
    for (const Point& corner : corners) {
      text += "vertex";
      append_point(text, corner);
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid\n";
}

}  // namespace

std::string encode_stl(const Model& model) {
  return float_exact(model.positions) ? encode_binary(model) : encode_text(model);
}

}  // namespace filmsticking::io
