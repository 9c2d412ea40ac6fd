#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the Debian packages, installs them on this machine, uses them, and removes them without a trace.
set -eu
project=$1 build_dir=$2 out=$3 cloud=$4 spot=$5
skip() { echo "$1"; exit 77; }
for tool in dpkg dpkg-deb dpkg-shlibdeps cpack; do
  command -v "$tool" >/dev/null || skip "$tool is not here"
done
[ "$(id -u)" = 0 ] || skip "only root can install packages"
if dpkg-query -W -f '${binary:Package} ${db:Status-Status}\n' '*filmsticking*' 2>/dev/null | grep -q ' installed$'; then
  skip "packages of this name are installed already"
fi

rm -rf "$out"
mkdir -p "$out"
cd "$out"
cpack --config "$build_dir/CPackConfig.cmake" -G DEB -B "$out" >cpack.log 2>&1 || { cat cpack.log; exit 1; }
packages=$(for deb in ./*.deb; do dpkg-deb --field "$deb" Package; done)
trap 'dpkg --purge $packages >/dev/null 2>&1 || true' EXIT

dpkg --install ./*.deb
files=$(for package in $packages; do dpkg --listfiles "$package"; done | sort -u)
c++ -std=c++17 "$project/core_only.cpp" -o core_only $(pkg-config --cflags --libs filmsticking_core)
./core_only  # the loader finds the library without a path to it
if [ -x /usr/bin/pcd_to_mesh ]; then /usr/bin/pcd_to_mesh "$cloud" "$out/mesh.ply" && [ -s "$out/mesh.ply" ]; fi
if [ -d /usr/lib/python3/dist-packages/filmsticking ]; then
  (cd / && PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 -m filmsticking "$spot" "$out/python.ply") && [ -s "$out/python.ply" ]
fi

dpkg --remove $packages
for file in $files; do
  if [ -f "$file" ]; then
    echo "$file is left after removal" >&2
    exit 1
  fi
done
if ldconfig -p | grep filmsticking; then
  echo "the loader still knows the libraries" >&2
  exit 1
fi
