#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Shared libraries carry a SONAME with the version, show their interface, and nothing else of their own.
set -eu
tree=$1
libraries=$(find "$tree" -type f -name 'libfilmsticking_*.so.*')
if [ -z "$libraries" ]; then
  echo "built static"
  exit 77
fi
for library in $libraries; do
  readelf -d "$library" | grep -qE 'SONAME.*libfilmsticking_(core|pcl)\.so\.[0-9]+\.[0-9]+\]' || {
    echo "$library has no SONAME with a version" >&2
    exit 1
  }
done

symbols() { nm -DC --defined-only $(find "$tree" -type f -name "libfilmsticking_$1.so.*") | cut -d' ' -f3-; }
fail() { echo "$1" >&2; exit 1; }

symbols core | grep -q '^filmsticking::reconstruct(' || fail "reconstruct() is not exported"
symbols core | grep -q '^filmsticking::describe(' || fail "describe() is not exported"
symbols core | grep -q '^filmsticking::point_normals(' || fail "point_normals() is not exported"
symbols core | grep -q '^filmsticking::find_holes(' || fail "find_holes() is not exported"
symbols core | grep -q '^filmsticking::Options::paper(' || fail "Options::paper() is not exported"
symbols core | grep -q '^filmsticking::Options::rd(' || fail "Options::rd() is not exported"
# Templates of the standard library and of Boost's exceptions may stand in any C++ library.
others=$(symbols core | grep -E '(^|[ <(])(filmsticking|CGAL|Eigen|tbb)::' | grep -vE '^filmsticking::(reconstruct|describe|point_normals|find_holes|Options::paper|Options::rd)\(' |
  grep -vE '^(void )?std::|^(typeinfo|vtable)' || true)
[ -z "$others" ] || fail "exported by mistake: $others"
if [[ $libraries == *libfilmsticking_pcl* ]]; then
  symbols pcl | grep -q '^pcl::FilmstickingPP<pcl::PointXYZRGB>::reconstruct(' || fail "the class is not exported"
  others=$(symbols pcl | grep -vE '^((typeinfo|typeinfo name|vtable) for )?pcl::FilmstickingPP<' || true)
  [ -z "$others" ] || fail "exported by mistake: $others"
fi
