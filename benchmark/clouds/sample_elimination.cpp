// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample_elimination.h"

#include "cell_grid.h"

namespace filmsticking::bench {
namespace {

/// The samples left, the one of largest weight on top; weights only fall.
class FallingHeap {
 public:
  explicit FallingHeap(std::vector<double> weights)
      : weight_(std::move(weights)), heap_(weight_.size()), place_(weight_.size()) {
    for (std::size_t i = 0; i < heap_.size(); ++i) put(i, static_cast<std::int32_t>(i));
    for (std::size_t i = heap_.size() / 2; i-- > 0;) sink(i);
  }

  std::int32_t pop() {
    const std::int32_t top = heap_[0], last = heap_.back();
    heap_.pop_back();
    place_[top] = -1;
    if (!heap_.empty()) {
      put(0, last);
      sink(0);
    }
    return top;
  }
  bool holds(std::int32_t sample) const { return place_[sample] >= 0; }
  void lower(std::int32_t sample, double by) {
    weight_[sample] -= by;
    sink(static_cast<std::size_t>(place_[sample]));
  }
  const std::vector<std::int32_t>& samples() const { return heap_; }

 private:
  void put(std::size_t at, std::int32_t sample) {
    heap_[at] = sample;
    place_[sample] = static_cast<std::int32_t>(at);
  }
  void sink(std::size_t at) {
    const std::int32_t sample = heap_[at];
    for (std::size_t child; (child = 2 * at + 1) < heap_.size(); at = child) {
      if (child + 1 < heap_.size() && weight_[heap_[child + 1]] > weight_[heap_[child]]) ++child;
      if (weight_[heap_[child]] <= weight_[sample]) break;
      put(at, heap_[child]);
    }
    put(at, sample);
  }

  std::vector<double> weight_;
  std::vector<std::int32_t> heap_;
  std::vector<std::int32_t> place_;  // in the heap; -1: taken out
};

/// Neighbours near each other in memory: millions of them are walked through again and again.
std::vector<Sample> by_cells(const std::vector<Sample>& samples, const Vec3& low, double side) {
  std::vector<Sample> ordered;
  ordered.reserve(samples.size());
  CellGrid(samples, low, side).each_cell([&](auto begin, auto end) {
    for (auto entry = begin; entry != end; ++entry) ordered.push_back(samples[entry->sample]);
  });
  return ordered;
}

}  // namespace

std::vector<Sample> eliminate_samples(const std::vector<Sample>& given, std::size_t count, double area,
                                      const Vec3& low) {
  if (given.size() <= count) return given;
  // Half the distance between neighbours of the densest packing, and the weights as in Yuksel's paper.
  const double largest = std::sqrt(area / (2 * std::sqrt(3.0) * static_cast<double>(count)));
  const double kept = static_cast<double>(count) / static_cast<double>(given.size());
  const double smallest = largest * (1 - std::pow(kept, 1.5)) * 0.65;
  const double reach = 2 * largest;
  const std::vector<Sample> candidates = by_cells(given, low, reach);
  const CellGrid grid(candidates, low, reach);
  const auto each_neighbour = [&](std::int32_t i, const auto& body) {
    const Sample& own = candidates[i];
    grid.each_near(own.position, [&](std::int32_t j) {
      if (j == i || own.normal.dot(candidates[j].normal) < 0) return;
      const double distance2 = (own.position - candidates[j].position).squaredNorm();
      if (distance2 >= reach * reach) return;
      const double x = 1 - std::max(std::sqrt(distance2), 2 * smallest) / reach, x2 = x * x, x4 = x2 * x2;
      body(j, x4 * x4);
    });
  };

  std::vector<double> weights(candidates.size(), 0);
  for (std::size_t i = 0; i < weights.size(); ++i)
    each_neighbour(static_cast<std::int32_t>(i), [&](std::int32_t, double w) { weights[i] += w; });
  FallingHeap heap(std::move(weights));
  while (heap.samples().size() > count)
    each_neighbour(heap.pop(), [&](std::int32_t j, double w) {
      if (heap.holds(j)) heap.lower(j, w);
    });
  std::vector<Sample> left;
  left.reserve(count);
  for (const std::int32_t i : heap.samples()) left.push_back(candidates[i]);
  return left;
}

}  // namespace filmsticking::bench
