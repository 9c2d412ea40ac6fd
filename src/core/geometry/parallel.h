// SPDX-License-Identifier: GPL-3.0-or-later
// Parallel loops whose results do not depend on the number of threads: chunks are fixed, and their results
// are joined in order.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace filmsticking {

/// Calls body(chunk, begin, end) for every chunk of [0, n).
template <class Body>
void parallel_chunks(std::size_t n, std::size_t chunk_size, const Body& body) {
  const std::size_t chunks = (n + chunk_size - 1) / chunk_size;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, chunks, 1),
                    [&](const tbb::blocked_range<std::size_t>& r) {
                      for (std::size_t c = r.begin(); c != r.end(); ++c)
                        body(c, c * chunk_size, std::min(n, (c + 1) * chunk_size));
                    });
}

/// Calls body(i) for every i of [0, n). Calls must not write to the same place.
template <class Body>
void parallel_each(std::size_t n, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, 256),
                    [&](const tbb::blocked_range<std::size_t>& r) {
                      for (std::size_t i = r.begin(); i != r.end(); ++i) body(i);
                    });
}

/// The sum of term(i) over [0, n), in the same order for any number of threads.
template <class Term>
double parallel_sum(std::size_t n, const Term& term) {
  constexpr std::size_t kChunk = 8192;
  std::vector<double> part((n + kChunk - 1) / kChunk, 0);
  parallel_chunks(n, kChunk, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    double sum = 0;
    for (std::size_t i = begin; i < end; ++i) sum += term(i);
    part[chunk] = sum;
  });
  double sum = 0;
  for (double p : part) sum += p;
  return sum;
}

}  // namespace filmsticking
