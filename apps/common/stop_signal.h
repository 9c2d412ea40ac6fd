// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>

namespace filmsticking::app {

/// Whether the process has received SIGINT or SIGTERM since stop_on_signal(). The program may set it, too.
extern std::atomic<bool> stop_asked;

/// Makes the first signal set `stop_asked`, so that the program can end cleanly. A second signal ends it at
/// once.
void stop_on_signal();

}  // namespace filmsticking::app
