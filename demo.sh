#!/usr/bin/env bash
# From an empty Debian 12 machine to scored rooms and their pictures. Arguments go to `scanchor run`.
set -euo pipefail
cd "$(dirname "$0")"
scripts/setup.sh
scripts/build.sh release --target scanchor
exec build/release/bin/scanchor run --out demo "$@"
