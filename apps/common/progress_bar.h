// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace filmsticking::app {

/// A line on stderr that shows the share done; nothing where stderr is not a terminal.
class ProgressBar {
 public:
  ProgressBar();
  ~ProgressBar();  ///< takes the line away
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(double share, const std::string& at_work);

  /// Takes the line away, so that another may be written; show() brings it back.
  void hide();

 private:
  bool terminal_;
  std::string shown_;
};

}  // namespace filmsticking::app
