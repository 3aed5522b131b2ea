#!/bin/sh
# Every test of Croquis: clang-tidy over the sources; natively as users run it, under AddressSanitizer and UBSan with
# clang (there with the fuzzers), and as WebAssembly under node; then the studio: its unit tests, its build, and its
# stories in a browser. All run even if one fails.
# usage: tools/test.sh JOBS
set -u
jobs=${1:-2}
failed=''

stage() {  # NAME COMMAND...
  name=$1
  shift
  echo "== $name"
  start=$(date +%s)
  if "$@"; then
    echo "== $name: passed in $(($(date +%s) - start)) s"
  else
    echo "== $name: FAILED after $(($(date +%s) - start)) s"
    failed="$failed, $name"
  fi
}

build_and_test() {  # PRESET CONFIGURE-OPTIONS...
  preset=$1
  shift
  cmake --preset "$preset" "$@" && cmake --build "build/$preset" -j "$jobs" && ctest --preset "$preset" -j "$jobs"
}

studio() {
  tools/build_studio.sh "$jobs" && (cd faces/studio && npm test && npm run stories)
}

stage 'lint' tools/lint.sh build "$jobs"
stage 'native' build_and_test release -DCROQUIS_TESTS=ON
stage 'sanitizers, fuzz' build_and_test asan -DCROQUIS_TESTS=ON -DCROQUIS_FUZZERS=ON
stage 'WebAssembly' build_and_test wasm -DCROQUIS_TESTS=ON
stage 'studio' studio

if [ -n "$failed" ]; then
  echo "make test: failed: ${failed#, }"
  exit 1
fi
echo 'make test: everything passed'
