#!/usr/bin/env bash
# Configures and builds one preset: scripts/build.sh [preset] [cmake --build arguments...]
set -euo pipefail
cd "$(dirname "$0")/.."
preset=${1:-release}
[ $# -gt 0 ] && shift
if [ ! -e "build/$preset/build.ninja" ]; then
  cmake --preset "$preset" >"/tmp/scanchor-configure-$$.log" 2>&1 || {
    cat "/tmp/scanchor-configure-$$.log" >&2
    rm -f "/tmp/scanchor-configure-$$.log"
    exit 1
  }
  rm -f "/tmp/scanchor-configure-$$.log"
fi
cmake --build "build/$preset" "$@"
