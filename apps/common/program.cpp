// SPDX-License-Identifier: GPL-3.0-or-later
#include "program.h"

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

#include "io/formats.h"
#include "io/with_file.h"
#include "usage_error.h"

namespace filmsticking::app {

void complain(const char* program, const std::string& what) {
  std::fprintf(stderr, "%s: %s.\n", program, what.c_str());
}

int run_program(const char* program, const std::function<int()>& body) noexcept {
  std::signal(SIGXFSZ, SIG_IGN);  // write() then fails past the size limit of files, as on a full disk
  try {
    return body();
  } catch (const UsageError& error) {
    complain(program, error.what());
    return kWrongUsage;
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "%s: the memory does not suffice.\n", program);
  } catch (const std::exception& error) {
    complain(program, error.what());
  }
  return kFailed;
}

io::Cloud read_points(const char* program, const std::string& path) {
  io::Cloud cloud = io::with_file(path, [&] { return io::read_cloud(path); });
  const std::string begin = path + ": ";
  for (const std::string& note : cloud.notes) complain(program, begin + note);
  return cloud;
}

}  // namespace filmsticking::app
