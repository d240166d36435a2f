#!/usr/bin/env bash
# Sets up, builds with warnings as errors and runs every test. Arguments go to ctest, e.g. ./test.sh -R perception
set -euo pipefail
cd "$(dirname "$0")"
scripts/setup.sh
scripts/build.sh ci
cd build/ci
ctest --output-on-failure -j "$(nproc)" "$@"
