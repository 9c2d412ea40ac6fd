#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds a project against an installed tree with find_package, and runs its programs.
set -eu
project=$1 tree=$2 out=$3 compiler=$4 launcher=$5
rm -rf "$out"
cp -r "$project" "$out-source.tmp"  # as a stranger's: outside of the tree that was built
trap 'rm -rf "$out-source.tmp"' EXIT
cmake -S "$out-source.tmp" -B "$out" -Wno-dev -DCMAKE_PREFIX_PATH="$tree" -DCMAKE_BUILD_TYPE=Debug \
  -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_COMPILER_LAUNCHER="$launcher"
cmake --build "$out"
for program in core_only own_point_type cloud; do
  [ ! -x "$out/$program" ] || "$out/$program"
done
