#!/bin/sh
# Builds the studio into build/studio: the engine as WebAssembly, then the page around it.
# usage: tools/build_studio.sh [JOBS]
set -eu
cd "$(dirname "$0")/.."
cmake --preset wasm >/dev/null
cmake --build build/wasm --target croquis_wasm -j "${1:-2}"
mkdir -p faces/studio/wasm
cp build/wasm/studio-engine/croquis.mjs build/wasm/studio-engine/croquis.wasm faces/wasm/croquis.d.mts faces/studio/wasm/
cd faces/studio
npm run build
