// SPDX-License-Identifier: GPL-3.0-or-later
// read_speed FILE: reads a cloud and prints megabytes a processor second, and the most memory beside that of
// the points.
#include <sys/resource.h>

#include <cstdio>
#include <exception>
#include <filesystem>

#include "io/formats.h"

namespace {

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace filmsticking;
  if (argc != 2) {
    std::fputs("usage: read_speed FILE\n", stderr);
    return 2;
  }
  try {
    const io::Cloud cloud = io::read_cloud(argv[1]);
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const double seconds = seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
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
