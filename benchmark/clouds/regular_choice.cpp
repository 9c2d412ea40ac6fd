// SPDX-License-Identifier: GPL-3.0-or-later
#include "regular_choice.h"

#include "cell_grid.h"

namespace filmsticking::bench {
namespace {

std::vector<std::int32_t> one_a_cell(const std::vector<Sample>& candidates, const Vec3& low, double side) {
  const CellGrid grid(candidates, low, side);
  std::vector<std::int32_t> chosen;
  grid.each_cell([&](auto begin, auto end) {
    const CellGrid::Cell cell = grid.cell_of(candidates[begin->sample].position);
    const Vec3 middle =
        low + side * Vec3(static_cast<double>(cell[0]) + 0.5, static_cast<double>(cell[1]) + 0.5,
                          static_cast<double>(cell[2]) + 0.5);
    const auto further = [&](const CellGrid::Entry& a, const CellGrid::Entry& b) {
      return (candidates[a.sample].position - middle).squaredNorm() <
             (candidates[b.sample].position - middle).squaredNorm();
    };
    chosen.push_back(std::min_element(begin, end, further)->sample);
  });
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

}  // namespace

std::vector<Sample> choose_regularly(const std::vector<Sample>& candidates, std::size_t count, double area,
                                     const Vec3& low, Random& random) {
  const double spacing = std::sqrt(area / static_cast<double>(count));
  double small = spacing / 16, large = spacing * 4;  // sides of cells: enough of them, too few
  for (int i = 0; i < 30; ++i) {
    const double side = std::sqrt(small * large);
    (one_a_cell(candidates, low, side).size() >= count ? small : large) = side;
  }
  std::vector<std::int32_t> chosen = one_a_cell(candidates, low, small);
  random.shuffle(chosen);
  if (chosen.size() > count) chosen.resize(count);
  std::vector<Sample> samples;
  for (const std::int32_t i : chosen) samples.push_back(candidates[i]);
  return samples;
}

}  // namespace filmsticking::bench
