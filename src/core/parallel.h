// SPDX-License-Identifier: GPL-3.0-or-later
// Parallel loops whose results cannot depend on the number of threads: the range is cut into fixed chunks,
// and whatever a chunk produces is kept apart until the chunks are joined in order.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstddef>

namespace filmsticking {

/// Calls body(chunk, begin, end) for every chunk of [0, n).
template <class Body>
void parallel_chunks(std::size_t n, std::size_t chunk_size, const Body& body) {
  const std::size_t chunks = (n + chunk_size - 1) / chunk_size;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, chunks, 1), [&](const tbb::blocked_range<std::size_t>& r) {
    for (std::size_t c = r.begin(); c != r.end(); ++c) body(c, c * chunk_size, std::min(n, (c + 1) * chunk_size));
  });
}

/// Calls body(i) for every i of [0, n); the calls must not touch each other's results.
template <class Body>
void parallel_each(std::size_t n, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, 256), [&](const tbb::blocked_range<std::size_t>& r) {
    for (std::size_t i = r.begin(); i != r.end(); ++i) body(i);
  });
}

}  // namespace filmsticking
