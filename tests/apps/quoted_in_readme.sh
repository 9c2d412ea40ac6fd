#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Every C++ block of a README must stand in the example, line by line and in that order; indentation and
# what the example has in between do not count.
set -eu
readme=$1 example=$2
awk '
  FNR == NR { line = $0; gsub(/^[ \t]+|[ \t]+$/, "", line); code[++n] = line; next }
  /^```cpp/ { inside = 1; blocks++; at = 0; next }
  /^```/ { inside = 0; next }
  inside {
    line = $0; gsub(/^[ \t]+|[ \t]+$/, "", line)
    if (line == "") next
    quoted++
    while (++at <= n && code[at] != line) {}
    if (at > n) { print "not in the example, or not in this order: " line; bad = 1; exit }
  }
  END { if (bad || !quoted) exit 1; print quoted " lines in " blocks " blocks" }
' "$example" "$readme"
