// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mutex>
#include <string>

#include "common/progress_bar.h"

namespace filmsticking::app {

/// The progress bar of a capture: the frames, and the mesh that is made at the same time. Calls may come from
/// several threads.
class CaptureBar {
 public:
  void show_frames(double share, const std::string& frames);
  void show_mesh(const std::string& mesh);

  /// Hides the bar and prints a line on stderr.
  void say(const std::string& line);

 private:
  void show();

  std::mutex mutex_;
  ProgressBar bar_;
  double share_ = 0;
  std::string frames_, mesh_;
};

}  // namespace filmsticking::app
