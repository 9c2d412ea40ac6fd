// SPDX-License-Identifier: GPL-3.0-or-later
#include "mixed_density.h"

#include <array>

#include "regular_choice.h"
#include "sample_elimination.h"

namespace filmsticking::bench {
namespace {

enum Third { Top, Middle, Bottom };

constexpr std::size_t kProbes = 200000;         // draws that measure the thirds
constexpr std::size_t kRegularCandidates = 40;  // a kept sample
constexpr double kDensity[3] = {4, 2, 1};
constexpr double kLeastShare = 1e-3;  // a third with less of the surface gets no samples

}  // namespace

std::vector<Sample> sample_mixed_density(const SurfaceSampler& surface, std::size_t count, Random& random) {
  const Vec3 extent = surface.high() - surface.low();
  int axis = 0;
  extent.maxCoeff(&axis);
  const double lower = surface.low()[axis] + extent[axis] / 3,
               upper = surface.high()[axis] - extent[axis] / 3;
  const auto third_of = [&](const Sample& sample) {
    const double x = sample.position[axis];
    return x >= upper ? Top : x >= lower ? Middle : Bottom;
  };

  std::array<double, 3> share{};
  for (std::size_t i = 0; i < kProbes; ++i) share[third_of(surface.draw(random))] += 1.0 / kProbes;
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    if (share[k] < kLeastShare) share[k] = 0;
    sum += kDensity[k] * share[k];
  }
  std::array<std::size_t, 3> wanted{};
  std::size_t rest = count;
  for (int k = 0; k < 3; ++k) {
    wanted[k] = static_cast<std::size_t>(static_cast<double>(count) * kDensity[k] * share[k] / sum);
    rest -= wanted[k];
  }
  *std::max_element(wanted.begin(), wanted.end()) += rest;

  const auto draw_in = [&](int third) {
    for (;;) {
      const Sample sample = surface.draw(random);
      if (third_of(sample) == third) return sample;
    }
  };
  constexpr std::size_t kCandidates[3] = {kCandidatesPerSample, 1, kRegularCandidates};
  std::vector<Sample> samples;
  for (int k = 0; k < 3; ++k) {
    if (wanted[k] == 0) continue;
    std::vector<Sample> part;
    while (part.size() < kCandidates[k] * wanted[k]) part.push_back(draw_in(k));
    const double area = surface.area() * share[k];
    if (k == Top) part = eliminate_samples(part, wanted[k], area, surface.low());
    if (k == Bottom) part = choose_regularly(part, wanted[k], area, surface.low(), random);
    while (part.size() < wanted[k]) part.push_back(draw_in(k));  // the regular choice ran out of cells
    samples.insert(samples.end(), part.begin(), part.end());
  }
  return samples;
}

}  // namespace filmsticking::bench
