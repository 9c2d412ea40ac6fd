// SPDX-License-Identifier: GPL-3.0-or-later
// Marks what the library shows; everything else is hidden when it is built.
#pragma once

#if defined(__GNUC__)
#define FILMSTICKING_EXPORT __attribute__((visibility("default")))
#else
#define FILMSTICKING_EXPORT
#endif
