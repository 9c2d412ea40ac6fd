// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "sample.h"

namespace filmsticking::bench {

/// Samples by the cells of a regular grid.
class CellGrid {
 public:
  CellGrid(const std::vector<Sample>& samples, const Vec3& low, double side) : low_(low), side_(side) {
    entries_.resize(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i)
      entries_[i] = {key(cell_of(samples[i].position)), static_cast<std::int32_t>(i)};
    std::sort(entries_.begin(), entries_.end());
  }

  using Cell = std::array<std::int64_t, 3>;
  Cell cell_of(const Vec3& p) const {
    Cell cell;
    for (int k = 0; k < 3; ++k) cell[k] = static_cast<std::int64_t>(std::floor((p[k] - low_[k]) / side_));
    return cell;
  }

  /// Calls body(sample) for all samples in the cell of `p` and in the 26 around it.
  template <class Body>
  void each_near(const Vec3& p, const Body& body) const {
    const Cell at = cell_of(p);
    for (std::int64_t x = at[0] - 1; x <= at[0] + 1; ++x)
      for (std::int64_t y = at[1] - 1; y <= at[1] + 1; ++y) {
        // The three cells of a column follow each other in the order of the keys.
        const std::uint64_t last = key({x, y, at[2] + 1});
        auto it = std::lower_bound(entries_.begin(), entries_.end(), Entry{key({x, y, at[2] - 1}), 0});
        for (; it != entries_.end() && it->key <= last; ++it) body(it->sample);
      }
  }

  /// Calls body(begin, end) for the samples of each cell that holds some.
  template <class Body>
  void each_cell(const Body& body) const {
    for (auto begin = entries_.begin(); begin != entries_.end();) {
      const auto end =
          std::find_if(begin, entries_.end(), [&](const Entry& e) { return e.key != begin->key; });
      body(begin, end);
      begin = end;
    }
  }

  struct Entry {
    std::uint64_t key;
    std::int32_t sample;
    bool operator<(const Entry& other) const {
      return key != other.key ? key < other.key : sample < other.sample;
    }
  };

 private:
  /// 21 bits an axis; one is added, so that the neighbours of the outermost cells have keys in order too.
  static std::uint64_t key(const Cell& cell) {
    std::uint64_t bits = 0;
    for (const std::int64_t c : cell) bits = bits << 21 | static_cast<std::uint64_t>((c + 1) & 0x1fffff);
    return bits;
  }

  Vec3 low_;
  double side_;
  std::vector<Entry> entries_;
};

}  // namespace filmsticking::bench
