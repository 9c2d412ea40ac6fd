// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes.h"

#include <cmath>
#include <locale>
#include <sstream>
#include <stdexcept>

namespace filmsticking::bench {
namespace {

constexpr int kAround = 128;  // corners around a sphere's equator or a torus
constexpr char kSlab[] = "slab:";

Mesh make_sphere() {
  constexpr int kRings = kAround / 2 - 1;  // between the poles
  Mesh mesh;
  mesh.positions.push_back({0, 0, 1});
  for (int i = 1; i <= kRings; ++i)
    for (int j = 0; j < kAround; ++j) {
      const double polar = M_PI * i / (kRings + 1), around = 2 * M_PI * j / kAround;
      mesh.positions.push_back(
          {std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar)});
    }
  mesh.positions.push_back({0, 0, -1});
  const auto at = [](int i, int j) { return 1 + i * kAround + j % kAround; };
  const int south = 1 + kRings * kAround;
  for (int j = 0; j < kAround; ++j) {
    mesh.triangles.push_back({0, at(0, j), at(0, j + 1)});
    for (int i = 0; i + 1 < kRings; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
    mesh.triangles.push_back({at(kRings - 1, j), south, at(kRings - 1, j + 1)});
  }
  return mesh;
}

Mesh make_torus() {
  constexpr double kBig = 1, kSmall = 0.4;
  constexpr int kAcross = kAround / 2;
  Mesh mesh;
  for (int i = 0; i < kAround; ++i)
    for (int j = 0; j < kAcross; ++j) {
      const double u = 2 * M_PI * i / kAround, v = 2 * M_PI * j / kAcross, r = kBig + kSmall * std::cos(v);
      mesh.positions.push_back({r * std::cos(u), r * std::sin(u), kSmall * std::sin(v)});
    }
  const auto at = [](int i, int j) { return i % kAround * kAcross + j % kAcross; };
  for (int i = 0; i < kAround; ++i)
    for (int j = 0; j < kAcross; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

/// The thickness t with t = k * sqrt(area / n) and area = 2 + 4 t.
double slab_thickness(double k, std::int64_t points) {
  const double x = 2 * k * k / static_cast<double>(points);
  return x + std::sqrt(x * x + x);
}

Mesh make_slab(double thickness) {
  Mesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.positions.push_back({double(i & 1), double(i >> 1 & 1), (i >> 2 & 1) * thickness});
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {2, 6, 7}, {2, 7, 3}};
  return mesh;
}

}  // namespace

bool is_shape(const std::string& name) {
  return name == "sphere" || name == "torus" || name.rfind(kSlab, 0) == 0;
}

Mesh make_shape(const std::string& name, std::int64_t points) {
  if (name == "sphere") return make_sphere();
  if (name == "torus") return make_torus();
  std::istringstream text(name.rfind(kSlab, 0) == 0 ? name.substr(sizeof kSlab - 1) : "");
  text.imbue(std::locale::classic());
  double k = 0;
  if (!(text >> k) || text.peek() != EOF || !(k > 0 && k < 1e6))
    throw std::invalid_argument("\"" + name +
                                "\" is no shape; there are sphere, torus and slab:K with K > 0");
  return make_slab(slab_thickness(k, points));
}

}  // namespace filmsticking::bench
