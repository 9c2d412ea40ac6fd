// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace filmsticking::io {

/// Refuses files of formats that are known, but not read, by their first bytes or else their extension
/// (".rcs"; empty: unknown), with the tool that converts them. Throws IoError.
void refuse_unread_formats(std::string_view bytes, const std::string& extension);

}  // namespace filmsticking::io
