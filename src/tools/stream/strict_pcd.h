// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace filmsticking::capture {

/// Refuses PCD files that are not written to the letter of the format, version 0.7: PCL's reader, which
/// pcl::PCDGrabber uses, crashes on some of them. Throws CaptureError.
void check_pcd(std::string_view bytes);

}  // namespace filmsticking::capture
