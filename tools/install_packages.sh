#!/usr/bin/env bash
# Installs packages.txt on Debian 12; with --all also what it marks as optional.
set -euo pipefail
cd "$(dirname "$0")/.."

wanted=$(grep -v '^#' packages.txt | grep -v '^$')
if [ "${1:-}" = "--all" ]; then
  wanted="$wanted $(sed -n 's/^#optional //p' packages.txt)"
fi

missing=""
for package in $wanted; do
  # Node from elsewhere brings its npm along, and Debian's conflicts with it.
  [ "$package" = npm ] && command -v npm >/dev/null && continue
  dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || missing="$missing $package"
done
if [ -z "$missing" ]; then
  echo "all packages are installed"
  exit 0
fi

as_root=""
[ "$(id -u)" = 0 ] || as_root="sudo"
echo "installing:$missing"
$as_root apt-get update -qq
# shellcheck disable=SC2086
$as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing
