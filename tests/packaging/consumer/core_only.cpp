// SPDX-License-Identifier: GPL-3.0-or-later
#include <filmsticking/reconstruct.h>

#include <cstdio>

int main() {
  const std::vector<filmsticking::Point> octahedron = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                                       {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
  const filmsticking::Result result = filmsticking::reconstruct(octahedron);
  std::printf("%s: %zu triangles\n", filmsticking::describe(result.status), result.triangles.size());
  return result.triangles.size() == 8 ? 0 : 1;
}
