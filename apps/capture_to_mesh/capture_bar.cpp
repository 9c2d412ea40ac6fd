// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture_bar.h"

#include <cstdio>

namespace filmsticking::app {

void CaptureBar::show_frames(double share, const std::string& frames) {
  const std::lock_guard<std::mutex> lock(mutex_);
  share_ = share;
  frames_ = frames;
  show();
}

void CaptureBar::show_mesh(const std::string& mesh) {
  const std::lock_guard<std::mutex> lock(mutex_);
  mesh_ = mesh;
  show();
}

void CaptureBar::say(const std::string& line) {
  const std::lock_guard<std::mutex> lock(mutex_);
  bar_.hide();
  std::fprintf(stderr, "%s\n", line.c_str());
}

void CaptureBar::show() { bar_.show(share_, frames_ + (mesh_.empty() ? "" : "; ") + mesh_); }

}  // namespace filmsticking::app
