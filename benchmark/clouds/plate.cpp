// SPDX-License-Identifier: GPL-3.0-or-later
#include "plate.h"

namespace filmsticking::bench {

Mesh make_plate(int cells, const Side& lower, const Side& upper) {
  Mesh mesh;
  for (const Side* side : {&lower, &upper})
    for (int j = 0; j <= cells; ++j)
      for (int i = 0; i <= cells; ++i) {
        const Vec3 p = (*side)(double(i) / cells, double(j) / cells);
        mesh.positions.push_back({p.x(), p.y(), p.z()});
      }
  const int top = (cells + 1) * (cells + 1);
  const auto at = [&](int i, int j) { return j * (cells + 1) + i; };
  const auto add_quadrilateral = [&](int a, int b, int c, int d) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  };
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      const int a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      add_quadrilateral(a, d, c, b);
      add_quadrilateral(top + a, top + b, top + c, top + d);
    }
  const auto add_rim = [&](int a, int b) { add_quadrilateral(a, b, top + b, top + a); };
  for (int i = 0; i < cells; ++i) {
    add_rim(at(i, 0), at(i + 1, 0));
    add_rim(at(cells, i), at(cells, i + 1));
    add_rim(at(i + 1, cells), at(i, cells));
    add_rim(at(0, i + 1), at(0, i));
  }
  return mesh;
}

}  // namespace filmsticking::bench
