#!/bin/sh
# Fails on any source that clang-format would lay out differently (`make format` repairs it) or that names no licence.
cd "$(dirname "$0")/.." || exit 1
command -v clang-format-14 >/dev/null 2>&1 || { echo 'clang-format-14 is not installed'; exit 77; }
unlicensed=$(git ls-files '*.h' '*.cpp' | xargs grep -L '^// SPDX-License-Identifier: MIT')
[ -z "$unlicensed" ] || { echo "No SPDX line: $unlicensed"; exit 1; }
git ls-files '*.h' '*.cpp' | xargs clang-format-14 --dry-run -Werror
