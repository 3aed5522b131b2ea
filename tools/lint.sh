#!/bin/sh
# clang-tidy over every source of the engine and the program. A room is read as one file, and the program is one room:
# the headers from outside, which cost ten seconds a file, then come once a room. Names of unnamed namespaces are
# therefore told apart within a room.
# usage: tools/lint.sh BUILD-FOLDER JOBS
set -eu
cd "$(dirname "$0")/.."
folder=$1/lint
jobs=$2
rm -rf "$folder"
mkdir -p "$folder"

for room in engine/croquis/*/ faces/cli/; do
  for file in $(find "$room" -name '*.cpp' | sort); do
    case $file in
      *_x86_64_v3.cpp | */kernels_any.cpp) ;;  # built for one processor: with flags of their own, or in place of another
      *) echo "#include \"$PWD/$file\"" >>"$folder/$(echo "${room%/}" | tr / _).cpp" ;;
    esac
  done
done

# The largest first, so that none is left running alone at the end.
ls -S "$folder"/*.cpp | xargs -P "$jobs" -I FILE clang-tidy-14 --quiet FILE -- \
  -std=c++20 -Iengine -Ifaces -isystem /usr/include/eigen3 -DCROQUIS_VERSION=\"0\" 2>"$folder/log" ||
  { grep -v ' warnings\? \(generated\|and\)' "$folder/log"; exit 1; }
