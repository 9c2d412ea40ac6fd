// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>
#include <stdexcept>

#include "level_surface.h"
#include "plate.h"
#include "surface_sampler.h"

namespace filmsticking::bench {
namespace {

constexpr int kAround = 128;  // corners around a sphere's equator or a torus
constexpr int kAlong = 64;    // cells along a side of a plate that is not plane

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

Mesh make_slab(double thickness) {
  return make_plate(
      1, [](double u, double v) { return Vec3(u, v, 0); },
      [&](double u, double v) { return Vec3(u, v, thickness); });
}

/// A slab with four by four hills on its upper side, a tenth of its width high.
Mesh make_relief(double thickness) {
  return make_plate(
      kAlong, [](double u, double v) { return Vec3(u, v, 0); },
      [&](double u, double v) {
        const double hill = (1 - std::cos(8 * M_PI * u)) * (1 - std::cos(8 * M_PI * v)) / 4;
        return Vec3(u, v, thickness + 0.1 * hill);
      });
}

/// A sixth of a sphere of radius 1, as a face of the cube around it sees it.
Mesh make_shell(double thickness) {
  const auto direction = [](double u, double v) { return Vec3(2 * u - 1, 2 * v - 1, 1).normalized(); };
  return make_plate(kAlong, direction,
                    [&](double u, double v) -> Vec3 { return (1 + thickness) * direction(u, v); });
}

// Signed distances, or bounds of them that have the same sign.

double to_ball(const Vec3& p, double radius) { return p.norm() - radius; }

/// A tube along the axis z with balls for ends.
double to_tube(const Vec3& p, double from, double to, double radius) {
  return (p - Vec3(0, 0, std::clamp(p.z(), from, to))).norm() - radius;
}

double without(double body, double hollow) { return std::max(body, -hollow); }

double cell_for(double size) { return std::min(0.03, size / 4); }

Mesh make_mouth(double width) {
  const auto field = [&](const Vec3& p) {
    return without(to_ball(p, 1), std::min(to_ball(p, 0.6), to_tube(p, 0, 2, width / 2)));
  };
  const Vec3 reach = Vec3::Constant(1.1);
  return make_level_surface(field, -reach, reach, cell_for(width));
}

Mesh make_bottle(double width) {
  constexpr double kWall = 0.08, kRadius = 0.6, kBottom = -0.5, kShoulder = 0.3, kTop = 1.4;
  const auto grown = [&](const Vec3& p, double by) {
    return std::min(to_tube(p, kBottom, kShoulder, kRadius + by),
                    to_tube(p, 0, 2 * kTop, width / 2 + kWall + by));
  };
  const auto field = [&](const Vec3& p) {
    return without(std::max(grown(p, 0), p.z() - kTop), grown(p, -kWall));
  };
  return make_level_surface(field, {-0.7, -0.7, -1.2}, {0.7, 0.7, 1.5}, cell_for(std::min(width, kWall)));
}

/// A ball with a hole that runs straight down and then around the axis twice.
Mesh make_spiral(double width) {
  constexpr double kRadius = 0.5, kTop = 0.4, kPitch = 0.45, kAngle = 4 * M_PI;
  const auto at = [](double angle) {  // counted down from the top
    return Vec3(kRadius * std::cos(angle), kRadius * std::sin(angle), kTop - kPitch * angle / (2 * M_PI));
  };
  // Round in planes through the axis.
  const auto to_hole = [&](const Vec3& p) {
    double nearest = (p - Vec3(kRadius, 0, std::max(p.z(), kTop))).norm();
    const double around = std::atan2(p.y(), p.x());
    for (double angle = around - 2 * M_PI; angle < kAngle + 2 * M_PI; angle += 2 * M_PI) {
      const double within = std::clamp(angle, 0.0, kAngle);
      const Vec3 c = at(within);
      nearest =
          std::min(nearest, within == angle ? std::hypot(std::hypot(p.x(), p.y()) - kRadius, p.z() - c.z())
                                            : (p - c).norm());
    }
    return nearest - width / 2;
  };
  const auto field = [&](const Vec3& p) { return without(to_ball(p, 1), to_hole(p)); };
  const Vec3 reach = Vec3::Constant(1.1);
  return make_level_surface(field, -reach, reach, cell_for(width));
}

Mesh make_nested() {
  const auto field = [](const Vec3& p) {
    return std::min(without(to_ball(p, 1), to_ball(p, 0.7)), to_ball(p, 0.4));
  };
  const Vec3 reach = Vec3::Constant(1.1);
  return make_level_surface(field, -reach, reach, cell_for(1));
}

Mesh make_chain(double radius) {
  constexpr int kLinks = 5;
  constexpr double kStep = 1.4;  // of the rings of radius 1, each a quarter turn from the one before
  const auto field = [&](const Vec3& p) {
    double nearest = INFINITY;
    for (int i = 0; i < kLinks; ++i) {
      const Vec3 q(p.x() - kStep * i, p[1 + i % 2], p[2 - i % 2]);
      nearest = std::min(nearest, std::hypot(std::hypot(q.x(), q.y()) - 1, q.z()) - radius);
    }
    return nearest;
  };
  return make_level_surface(field, {-1.4, -1.4, -1.4}, {kStep * (kLinks - 1) + 1.4, 1.4, 1.4},
                            cell_for(2 * radius));
}

/// Tubes along the edges of two by two by two cubes of side 1.
Mesh make_lattice(double radius) {
  const auto field = [&](const Vec3& p) {
    const Vec3 inside = p.cwiseMax(0).cwiseMin(2), corner = inside.array().round();
    double nearest = INFINITY;
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 q = corner;
      q[axis] = inside[axis];
      nearest = std::min(nearest, (p - q).norm());
    }
    return nearest - radius;
  };
  return make_level_surface(field, Vec3::Constant(-0.5), Vec3::Constant(2.5), cell_for(2 * radius));
}

/// A family of shapes, and the size that makes sense last.
struct Family {
  const char* name;
  Mesh (*make)(double size);
  double most;
};
constexpr Family kFamilies[] = {{"slab", make_slab, 1e6},     {"shell", make_shell, 1},
                                {"relief", make_relief, 1e6}, {"mouth", make_mouth, 0.8},
                                {"bottle", make_bottle, 0.8}, {"spiral", make_spiral, 0.35},
                                {"chain", make_chain, 0.28},  {"lattice", make_lattice, 0.35}};

const Family* family_of(const std::string& name) {
  for (const Family& family : kFamilies)
    if (name.rfind(std::string(family.name) + ':', 0) == 0) return &family;
  return nullptr;
}

/// The member whose size is k sqrt(area / points). The area grows no faster than the size does, so every
/// round at least halves the error; the rest is below a thousandth.
Mesh fit(const Family& family, double k, std::int64_t points) {
  constexpr int kRounds = 12;
  double size = std::min(0.1, family.most);
  Mesh mesh = family.make(size);
  for (int round = 0; round < kRounds; ++round) {
    const double before = size;
    size = k * std::sqrt(SurfaceSampler(mesh).area() / static_cast<double>(points));
    if (!(size <= family.most)) {
      if (round + 1 == kRounds || before == family.most)
        throw std::invalid_argument(std::string(family.name) + " cannot be so wide; take more points");
      size = family.most;
    }
    mesh = family.make(size);
    if (std::abs(size - before) < 1e-3 * size) break;
  }
  return mesh;
}

}  // namespace

bool is_shape(const std::string& name) {
  return name == "sphere" || name == "torus" || name == "nested" || family_of(name);
}

Mesh make_shape(const std::string& name, std::int64_t points) {
  if (name == "sphere") return make_sphere();
  if (name == "torus") return make_torus();
  if (name == "nested") return make_nested();
  const Family* family = family_of(name);
  std::istringstream text(family ? name.substr(name.find(':') + 1) : "");
  text.imbue(std::locale::classic());
  double k = 0;
  if (!(text >> k) || text.peek() != EOF || !(k > 0 && k < 1e6)) {
    std::string names = "sphere, torus, nested";
    for (const Family& known : kFamilies) names += std::string(", ") + known.name + ":K";
    throw std::invalid_argument("\"" + name + "\" is no shape; there are " + names + " with K > 0");
  }
  return fit(*family, k, points);
}

}  // namespace filmsticking::bench
