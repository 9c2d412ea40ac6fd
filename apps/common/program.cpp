// SPDX-License-Identifier: GPL-3.0-or-later
#include "program.h"

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

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

}  // namespace filmsticking::app
