// SPDX-License-Identifier: GPL-3.0-or-later
// read_speed FILE: reads a cloud and prints megabytes a second, and the most memory over that of the points.
#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>

#include "io/formats.h"

int main(int argc, char** argv) {
  using namespace filmsticking;
  if (argc != 2) {
    std::fputs("usage: read_speed FILE\n", stderr);
    return 2;
  }
  try {
    const auto begin = std::chrono::steady_clock::now();
    const io::Cloud cloud = io::read_cloud(argv[1]);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const double megabytes = 1e-6 * static_cast<double>(std::filesystem::file_size(argv[1])),
                 memory = 1e-3 * static_cast<double>(usage.ru_maxrss),
                 points = 1e-6 * static_cast<double>(cloud.points.data.size());
    std::printf("%zu points, %.0f MB in %.2f s: %.0f MB/s; %.0f MB of memory at most for %.0f MB of points\n",
                io::size_of(cloud.points), megabytes, seconds, megabytes / seconds, memory, points);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", argv[1], error.what());
    return 1;
  }
}
