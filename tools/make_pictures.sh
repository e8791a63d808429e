#!/usr/bin/env bash
# Makes the pictures of README.md again: the lamp post solved as it is, and solved after repair.
# usage: tools/make_pictures.sh RADFIX    the program, such as build/release/bin/radfix
set -euo pipefail
radfix=$(realpath "${1:?usage: tools/make_pictures.sh RADFIX}")
cd "$(dirname "$0")/.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Coarse on purpose: what a defect spoils is as wide as an element.
sizes=(--patch-size 0.8 --element-size 0.4)

picture() {  # NAME EXPECTED-EXIT-CODE OPTION…
  local status=0
  "$radfix" corpus/models/lamp_post.obj -o "$work/$1.glb" --solve --preview "docs/pictures/lamp_post_$1.png" \
    "${sizes[@]}" "${@:3}" || status=$?
  if [ "$status" != "$2" ]; then
    echo "lamp_post_$1.png: radfix ended with $status instead of $2" >&2
    exit 1
  fi
}

mkdir -p docs/pictures
picture before 1 --skip repair
picture after 0
