// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as options and coordinates: the promise of reconstruct() holds.
#include <vector>

#include "filmsticking/reconstruct.h"
#include "property/promise.h"
#include "target.h"

namespace {

using filmsticking::Method;
using filmsticking::Point;
using filmsticking::test::ByteReader;

// Small enough for many inputs a second, as faults of geometry are seldom for want of points.
constexpr std::size_t kMostPoints = 60, kMostPointsInFilm = 24;  // a film step costs more than carving
constexpr int kVirtualSites = 60;                                // in place of the paper's 1000

/// Whole numbers make grids: points on one line, plane and sphere, and points at one place.
enum Number { Double, Float, Byte, Short };

double take(ByteReader& bytes, int number) {
  switch (number) {
    case Double:
      return bytes.take<double>();
    case Float:
      return static_cast<double>(bytes.take<float>());
    case Byte:
      return bytes.take<std::int8_t>();
    default:
      return bytes.take<std::int16_t>() / 256.0;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ByteReader bytes(data, size);
  const auto choices = bytes.take<std::uint8_t>();
  filmsticking::Options options;
  options.threads = 1;
  options.open_boundary = (choices & 1) != 0;
  options.keep_outliers = (choices & 2) != 0;
  options.sharp_edges = (choices & 16) == 0;
  // One in eight starts from a sphere, one in sixteen as in the paper: both take a hundred times as long.
  const int start = choices >> 4 & 15, number = choices >> 2 & 3;
  const bool paper = start == 15, film = start > 12;
  if (film) options.method = Method::Film;
  if (paper)
    options = filmsticking::Options::paper(), options.threads = 1, options.virtual_sites = kVirtualSites;
  if (film) options.max_steps = 8, options.max_rounds = 1;

  std::vector<Point> points;
  while (!bytes.empty() && points.size() < (film ? kMostPointsInFilm : kMostPoints)) {
    Point& p = points.emplace_back();
    for (double& x : p) x = take(bytes, number);
  }
  filmsticking::test::require_no_fault(filmsticking::test::fault_of(
      filmsticking::reconstruct(points, options), points, options.open_boundary));
  return 0;
}
