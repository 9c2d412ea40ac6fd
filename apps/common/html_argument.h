// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "arguments.h"

namespace filmsticking::app {

/// --html FILE.html; other names are refused, so that no mesh is overwritten by mistake.
inline void add_html(Arguments& arguments, const std::string& help, std::string& path) {
  arguments.option("--html", "FILE.html", help, [&path](const std::string& text) {
    const std::size_t dot = text.rfind('.');
    if (dot == std::string::npos || (text.substr(dot) != ".html" && text.substr(dot) != ".htm"))
      throw UsageError("--html takes a file that ends with .html, not '" + text + "'");
    path = text;
  });
}

}  // namespace filmsticking::app
