#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds programs against an installed tree with pkg-config alone, and runs them.
set -eu
project=$1 tree=$2 out=$3 compiler=$4
rm -rf "$out"
mkdir -p "$out"
PKG_CONFIG_PATH=$(dirname "$(find "$tree" -name filmsticking_core.pc)")
export PKG_CONFIG_PATH

build_and_run() {
  local program=$1 package=$2
  pkg-config --exists --print-errors "$package"
  # shellcheck disable=SC2046  # flags are words
  "$compiler" -std=c++17 "$project/$program.cpp" -o "$out/$program" $(pkg-config --cflags --libs "$package") \
    "-Wl,-rpath,$(pkg-config --variable=libdir "$package")"
  "$out/$program"
}
build_and_run core_only filmsticking_core
if pkg-config --exists filmsticking_pcl; then
  build_and_run cloud filmsticking_pcl
  build_and_run own_point_type filmsticking_pcl
fi
