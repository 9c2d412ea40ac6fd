// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>

namespace filmsticking::app {

/// Whether SIGINT or SIGTERM has come since stop_on_signal(); settable by the program too.
extern std::atomic<bool> stop_asked;

/// From now on the first signal sets `stop_asked`, so that a program can end cleanly; a second one ends it at
/// once.
void stop_on_signal();

}  // namespace filmsticking::app
