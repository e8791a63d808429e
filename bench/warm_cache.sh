#!/bin/sh
# Prints what the cache is worth: seconds for a folder of small models without it, with an empty one and with a full one.
#
# usage: warm_cache.sh RADLINT [FILES]
set -eu
radlint=$(realpath "$1")
files=${2:-2000}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 "$(dirname "$0")/small_models.py" "$folder/models" "$files"
cd "$folder"
sleep 3 # what was written within the last moments is told by content, not by time

seconds() {
  best=
  for _ in 1 2 3 4 5; do
    prepare
    start=$(date +%s%N)
    "$radlint" models "$@" >/dev/null || [ $? -eq 1 ]
    taken=$(($(date +%s%N) - start))
    if [ -z "$best" ] || [ "$taken" -lt "$best" ]; then best=$taken; fi
  done
  echo "$best"
}

prepare() { :; }
without=$(seconds --no-cache)
prepare() { rm -rf cache; }
empty=$(seconds --cache cache)
prepare() { :; }
full=$(seconds --cache cache)
awk -v n="$files" -v a="$without" -v b="$empty" -v c="$full" 'BEGIN {
  printf "%d files, the best of five runs each\n", n
  printf "without a cache    %.3f s\nwith an empty one  %.3f s\nwith a full one    %.3f s\n", a / 1e9, b / 1e9, c / 1e9
  printf "full against none  %.1f times faster\nfull against empty %.1f times faster\n", a / c, b / c }'
