// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cloud.h"

namespace filmsticking::io {

/// Appends the points of another cloud. Fields that only one of them has are left out, with a note. Colours
/// stay where both have them; positions are FLOAT64 unless both have FLOAT32. Where both say where the sensor
/// was, every point keeps its own viewpoint. Throws IoError.
void append(Cloud& cloud, Cloud other);

}  // namespace filmsticking::io
