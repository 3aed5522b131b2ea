#!/bin/sh
# Every test of Croquis: natively as users run it, under AddressSanitizer and UBSan with clang (there with clang-tidy
# and the fuzzers), and as WebAssembly under node. All three run even if one fails.
# usage: tools/test.sh JOBS
set -u
jobs=${1:-2}
failed=''

stage() {  # NAME PRESET CONFIGURE-OPTIONS...
  name=$1 preset=$2
  shift 2
  echo "== $name"
  start=$(date +%s)
  if cmake --preset "$preset" "$@" && cmake --build "build/$preset" -j "$jobs" && ctest --preset "$preset" -j "$jobs"; then
    echo "== $name: passed in $(($(date +%s) - start)) s"
  else
    echo "== $name: FAILED after $(($(date +%s) - start)) s"
    failed="$failed $preset"
  fi
}

stage 'native' release -DCROQUIS_TESTS=ON
stage 'sanitizers, lint, fuzz' asan -DCROQUIS_TESTS=ON -DCROQUIS_FUZZERS=ON
stage 'WebAssembly' wasm -DCROQUIS_TESTS=ON

if [ -n "$failed" ]; then
  echo "make test: failed:$failed"
  exit 1
fi
echo 'make test: everything passed'
