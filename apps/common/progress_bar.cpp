// SPDX-License-Identifier: GPL-3.0-or-later
#include "progress_bar.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace filmsticking::app {

constexpr int kWidth = 40;

ProgressBar::ProgressBar() : terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() { hide(); }

void ProgressBar::hide() {
  if (!shown_.empty()) std::fputs("\r\033[K", stderr);
  shown_.clear();
}

void ProgressBar::show(double share, const std::string& at_work) {
  if (!terminal_) return;
  share = std::clamp(share, 0.0, 1.0);
  const auto full = static_cast<std::size_t>(share * kWidth);
  std::string line = "[" + std::string(full, '=') + std::string(kWidth - full, ' ') + "] " +
                     std::to_string(static_cast<int>(share * 100)) + " % " + at_work;
  if (line == shown_) return;
  std::fprintf(stderr, "\r%s\033[K", line.c_str());
  shown_ = std::move(line);
}

}  // namespace filmsticking::app
