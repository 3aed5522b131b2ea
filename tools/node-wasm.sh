#!/bin/sh
# Runs a WebAssembly test program under node. Emscripten 3.1.6 would load its .wasm with fetch() where node has one,
# which cannot open files; the switch is unknown to no node from 18 on.
exec node --no-experimental-fetch "$@"
