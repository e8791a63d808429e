#!/usr/bin/env bash
# What to run before a change is handed in: layout of the code, layers, tests, static checks of what has changed.
set -euo pipefail
cd "$(dirname "$0")/.."

changed=$(git diff --name-only --diff-filter=d HEAD -- '*.cpp' '*.h'
          git ls-files --others --exclude-standard -- '*.cpp' '*.h')
if [ -n "$changed" ] && command -v clang-format >/dev/null; then
  # shellcheck disable=SC2086
  clang-format --dry-run --Werror $changed
fi
python3 tools/check_includes.py .
tools/run_tests.sh
if [ -n "$changed" ] && command -v clang-tidy >/dev/null; then
  sources=$(echo "$changed" | grep '\.cpp$' || true)
  # shellcheck disable=SC2086
  [ -z "$sources" ] || clang-tidy -p build/dev --quiet $sources
fi
echo "ready"
