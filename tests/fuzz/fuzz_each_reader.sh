#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Fuzzes the readers one after another, in rounds, and notes processor seconds and runs of each round.
# What they found to be new stays in WORK/READER; a fault ends the reader's rounds, its input is in WORK/faults.
# Usage: fuzz_each_reader.sh FUZZ_READERS WORK [SECONDS_A_ROUND [ROUNDS [READER...]]]
set -eu
program=$(realpath "$1") work=$2 seconds=${3:-120} rounds=${4:-15}
shift $(($# < 4 ? $# : 4))
readers=${*:-pcd ply obj stl vtk xyz off las ptx grid columns frame trajectory}
tests=$(realpath "$(dirname "$0")/..")
mkdir -p "$work/seeds" "$work/faults"
cd "$work"
[ -n "$(ls seeds)" ] || python3 "$tests/data/formats/make_corpus.py" seeds 20

for ((round = 1; round <= rounds; ++round)); do
  for reader in $readers; do
    [ -z "$(ls faults | grep "^$reader-" || true)" ] || continue
    mkdir -p "$reader"
    times=$( { TIMEFORMAT='%U %S'; time FUZZ_READER=$reader nice -n 19 "$program" -max_total_time="$seconds" \
      -rss_limit_mb=4096 -timeout=20 -max_len=65536 -len_control=20 -dict="$tests/fuzz/readers.dict" -print_final_stats=1 \
      -artifact_prefix="faults/$reader-" "$reader" seeds "$tests/fuzz/corpus/readers" >"$reader.log" 2>&1 || true; } 2>&1)
    runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$reader.log")
    echo "$reader $times ${runs:-0}" >>rounds.txt
  done
done
