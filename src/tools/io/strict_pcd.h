// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace filmsticking::io {

/// Refuses PCD files that are not written to the letter of version 0.7. PCL's own reader of headers, which
/// pcl::PCDGrabber uses, crashes on some of them. A file that passes is also one for decode_pcd(), but for
/// text that is no number. Throws IoError.
void check_pcd(std::string_view bytes);

}  // namespace filmsticking::io
