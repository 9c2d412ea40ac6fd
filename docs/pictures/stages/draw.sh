#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Draws the figures of docs/method.md and docs/stages/ into the folder that is given, by default this one.
# Needs a build with -DFILMSTICKING_BUILD_BENCHMARKS=ON in build/, and xvfb-run.
set -eu
cd "$(dirname "$0")/../../.."
out=${1:-docs/pictures/stages}
bin=${BIN:-build/bin}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

snapshot() {  # FILE SIZE OPTIONS.. -- MESH:LABEL..
  local file=$1 size=$2 options=() panels=()
  shift 2
  while [ "$1" != -- ]; do options+=("$1") && shift; done
  for panel in "${@:2}"; do panels+=("$work/${panel%%:*}.ply" --label "${panel#*:}"); done
  xvfb-run -a "$bin/mesh_snapshot" "${panels[@]}" "${options[@]}" --colours --grey-backs --size "$size" \
    -o "$out/$file"
}

"$bin/draw_stages" docs/pictures/stages/clamp.ply "$work"
clamp=(--view=-8,25 --columns 3)
snapshot overview.png 1050x750 "${clamp[@]}" -- points:'1 points' votes:'2 facets by votes' \
  field:'3 signed field' cut:'4 minimum cut' mended:'5 repaired and mended' sharp:'6 sharp edges'
snapshot points.png 400x430 "${clamp[@]}" -- points:'5,500 points'
snapshot delaunay.png 800x500 --view=-8,25 --edges -- guess:'a section of the tetrahedra'
snapshot evidence.png 1200x430 "${clamp[@]}" -- votes:'facets by votes' guess:'start: the film' \
  field:'signed field'
snapshot labelling.png 1200x430 "${clamp[@]}" -- cut:'cut' repaired:'repaired and warped' mended:'mended'
snapshot surface.png 800x430 "${clamp[@]}" -- mended:'before the flips' sharp:'after'

"$bin/pcd_to_mesh" docs/pictures/stages/clamp.ply "$work/stable_clamp.ply" --stability
"$bin/pcd_to_mesh" tests/data/spot_10k.ply "$work/stable_spot.ply" --stability
snapshot stability.png 800x430 --view=-8,25 --fit each -- stable_clamp:'5,500 points' stable_spot:'10,000 points'

"$bin/pcd_to_mesh" tests/data/spot_10k.ply "$work/film.ply" --init sphere --dump-steps "$work"
snapshot film.png 1200x330 --view 150,20 --fit each -- step_000:'bounding sphere' step_002:'after two steps' \
  step_004:'after four' film:'result'
