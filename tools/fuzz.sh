#!/bin/sh
# Runs every fuzzer for a while, starting from its corpus and whatever it has found on earlier runs.
# usage: tools/fuzz.sh JOBS SECONDS
set -eu
jobs=$1 seconds=$2
cmake --preset asan -DCROQUIS_FUZZERS=ON
cmake --build build/asan --target fuzzers -j "$jobs"
cd build/asan
mkdir -p found
# One fuzzer per job; each writes its inputs of interest and its crashes to found/NAME.
ls tests/fuzz/*_fuzz | xargs -P "$jobs" -I{} sh -c '
  name=$(basename {})
  mkdir -p found/$name
  corpus=../../tests/fuzz/corpus/${name%_fuzz}
  words=../../tests/fuzz/dictionary/${name%_fuzz}.txt
  echo "$name: $0 s"
  {} -max_total_time=$0 -timeout=10 -rss_limit_mb=4096 -artifact_prefix=found/$name- -dict=$words found/$name $corpus >found/$name.log 2>&1 ||
    { tail -n 40 found/$name.log; exit 1; }
  tail -n 1 found/$name.log' "$seconds"
