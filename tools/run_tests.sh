#!/usr/bin/env bash
# Installs what is needed, builds everything and runs every test. Arguments go to ctest.
# RAD_PRESET chooses another preset: asan-ubsan, tsan.
set -euo pipefail
cd "$(dirname "$0")/.."

preset=${RAD_PRESET:-dev}
tools/install_packages.sh
cmake --preset "$preset"
cmake --build --preset "$preset"
ctest --preset "$preset" "$@"
