// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace filmsticking::page {

/// Files that a page is made of, as they were when the program was built (page_files.cpp.in).
extern const char* const kPageHtml;  ///< with the marks that write_page() replaces
extern const char* const kPageScript;
extern const char* const kThree;  ///< three.js and its parts, with their licence

}  // namespace filmsticking::page
