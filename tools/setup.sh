#!/bin/sh
# Installs what a target of the Makefile lacks, and nothing where nothing is lacking: Debian packages through apt-get
# (as root or through sudo), npm packages into node_modules.
# usage: tools/setup.sh GROUP...   groups: program tests bench fuzz format npm page browser
set -eu
cd "$(dirname "$0")/.."

packages_of() {
  case $1 in
    program) echo ninja-build libeigen3-dev nlohmann-json3-dev libstb-dev libcli11-dev libcpp-httplib-dev \
                  libegl-dev libgles-dev libegl1 libgl1-mesa-dri ;;
    tests)   echo ccache googletest clang-14 libclang-rt-14-dev clang-format-14 clang-tidy-14 emscripten ;;
    bench)   echo libbenchmark-dev ;;
    fuzz)    echo ninja-build libeigen3-dev nlohmann-json3-dev libstb-dev clang-14 libclang-rt-14-dev ;;
    format)  echo clang-format-14 ;;
    page)    echo ccache emscripten ninja-build libeigen3-dev nlohmann-json3-dev libstb-dev ;;
    browser) echo chromium fonts-dejavu-core ;;
    npm)     ;;
    *)       echo "tools/setup.sh: no group '$1'" >&2; exit 2 ;;
  esac
}

# What may have come from elsewhere than a Debian package is asked for as a command.
commands_of() {
  case $1 in
    program) echo g++:g++ cmake:cmake ;;
    tests)   echo node:nodejs ;;
    fuzz)    echo cmake:cmake ;;
    npm)     echo node:nodejs npm:npm ;;
    page)    echo node:nodejs npm:npm cmake:cmake ;;
    *)       ;;
  esac
}

lacking=''
npm_folders=''
for group in "$@"; do
  listed=$(packages_of "$group")
  for package in $listed; do
    status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
    [ "$status" = installed ] || lacking="$lacking $package"
  done
  for pair in $(commands_of "$group"); do
    command -v "${pair%%:*}" >/dev/null 2>&1 || lacking="$lacking ${pair#*:}"
  done
  [ "$group" != npm ] || npm_folders="$npm_folders ."
  [ "$group" != page ] || npm_folders="$npm_folders faces/studio"
done

if [ -n "$lacking" ]; then
  lacking=$(printf '%s\n' $lacking | sort -u | tr '\n' ' ')
  lacking=${lacking% }
  install="apt-get install -y --no-install-recommends $lacking"
  if ! command -v apt-get >/dev/null 2>&1; then
    echo "Croquis needs these Debian packages, or what they are called on this system: $lacking" >&2
    exit 1
  elif [ "$(id -u)" = 0 ]; then
    as_root=''
  elif command -v sudo >/dev/null 2>&1; then
    as_root='sudo'
  else
    echo "Croquis needs some Debian packages, and this is neither root nor is there sudo. Have an administrator run:" >&2
    echo "  apt-get update && $install" >&2
    exit 1
  fi
  echo "Installing with apt: $lacking"
  export DEBIAN_FRONTEND=noninteractive
  # Old package lists name files that are gone, and a fresh machine has none: read them first.
  $as_root apt-get update -qq
  # shellcheck disable=SC2086
  $as_root env DEBIAN_FRONTEND=noninteractive $install -qq
fi

for folder in $npm_folders; do
  if ! cmp -s "$folder/package-lock.json" "$folder/node_modules/.croquis-lock"; then
    echo "Installing with npm for $folder/package.json"
    (cd "$folder" && npm ci --no-audit --no-fund)
    cp "$folder/package-lock.json" "$folder/node_modules/.croquis-lock"
  fi
done
