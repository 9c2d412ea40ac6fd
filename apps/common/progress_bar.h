// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace filmsticking::app {

/// A line on stderr that shows the share of the work done. Prints nothing if stderr is not a terminal.
class ProgressBar {
 public:
  ProgressBar();
  ~ProgressBar();  ///< clears the line
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// `share`: from 0 to 1; `at_work`: the name of the stage.
  void show(double share, const std::string& at_work);

  /// Clears the line, so that the program can print another; show() draws it again.
  void hide();

 private:
  bool terminal_;
  std::string shown_;
};

}  // namespace filmsticking::app
