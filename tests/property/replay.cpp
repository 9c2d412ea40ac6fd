// SPDX-License-Identifier: GPL-3.0-or-later
#include "replay.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace filmsticking::test {

std::string isolated(const std::function<std::string(const std::vector<Point>&)>& fault,
                     const std::vector<Point>& points, int patience) {
  int ends[2];
  if (pipe(ends) != 0) std::abort();
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) std::abort();
  if (child == 0) {
    close(ends[0]);
    alarm(static_cast<unsigned>(patience));
    const std::string wrong = fault(points);
    const ssize_t written = write(ends[1], wrong.data(), wrong.size());
    _exit(written == static_cast<ssize_t>(wrong.size()) ? 0 : 1);
  }
  close(ends[1]);
  std::string wrong;
  char buffer[256];
  for (ssize_t n; (n = read(ends[0], buffer, sizeof buffer)) > 0;)
    wrong.append(buffer, static_cast<std::size_t>(n));
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFSIGNALED(status))
    return WTERMSIG(status) == SIGALRM ? "no end" : "signal " + std::to_string(WTERMSIG(status));
  return wrong;
}

std::vector<Point> shrink(std::vector<Point> points,
                          const std::function<std::string(const std::vector<Point>&)>& fault) {
  const std::string wanted = fault(points);
  if (wanted.empty()) return points;
  for (std::size_t chunk = std::max<std::size_t>(1, points.size() / 2);;) {
    bool smaller = false;
    for (std::size_t begin = 0; begin < points.size();) {
      std::vector<Point> rest = points;
      const auto at = rest.begin() + static_cast<std::ptrdiff_t>(begin);
      rest.erase(at, at + static_cast<std::ptrdiff_t>(std::min(chunk, points.size() - begin)));
      if (fault(rest) == wanted) {
        points = std::move(rest);
        smaller = true;
      } else {
        begin += chunk;
      }
    }
    if (chunk > 1) {
      chunk /= 2;
    } else if (!smaller) {
      return points;
    }
  }
}

void write_points(const std::string& path, const std::vector<Point>& points) {
  std::FILE* file = std::fopen(path.c_str(), "w");
  if (!file) std::abort();
  for (const Point& p : points) std::fprintf(file, "%.17g %.17g %.17g\n", p[0], p[1], p[2]);
  std::fclose(file);
}

}  // namespace filmsticking::test
