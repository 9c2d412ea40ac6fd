#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs to one folder, moves all to another, and looks for what still points back.
set -eu
source_dir=$1 build_dir=$2 out=$3
rm -rf "$out/first" "$out/moved"
cmake --install "$build_dir" --prefix "$out/first" >/dev/null
mv "$out/first" "$out/moved"

if grep -rIl -e "$source_dir" -e "$build_dir" -e "$out/first" "$out/moved"; then
  echo "these installed files name a folder of this machine" >&2
  exit 1
fi
for file in $(find "$out/moved" -type f -path '*/bin/*' -o -type f -name '*.so.*'); do
  if readelf -d "$file" | grep -E 'R(UN)?PATH' | grep -q -e "$source_dir" -e "$out"; then
    echo "$file looks for libraries in a folder of this machine" >&2
    exit 1
  fi
  if env -u LD_LIBRARY_PATH ldd "$file" | grep 'not found'; then
    echo "$file does not find its libraries after the move" >&2
    exit 1
  fi
done
packages="$out/moved/lib/python3/dist-packages"
if [ -d "$packages" ]; then
  cd /  # not in a folder with a package of this name
  PYTHONPATH=$packages PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 -c '
import numpy, filmsticking
assert filmsticking.reconstruct(numpy.random.default_rng(1).normal(size=(100, 3))).report.closed'
fi
if [ -x "$out/moved/bin/pcd_to_mesh" ]; then
  "$out/moved/bin/pcd_to_mesh" --help >/dev/null
fi
