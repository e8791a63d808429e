#!/usr/bin/env bash
# Installs what is needed, builds radlint and radfix, and takes a bundled model from its faults to a lit scene.
# usage: tools/build_and_run.sh [MODEL]
set -euo pipefail
cd "$(dirname "$0")/.."

tools/install_packages.sh
cmake --preset release -DRAD_TESTS=OFF -DRAD_BENCH=OFF
cmake --build --preset release --target radlint radfix

bin=build/release/bin
model=${1:-corpus/models/lamp_post.obj}
name=$(basename "${model%.*}")
lit=build/release/${name}_lit.glb
picture=build/release/${name}_lit.png

step() { printf '\n=== %s\n$ %s\n' "$1" "${*:2}"; }

step "1. What is wrong with the model" radlint "$model"
status=0
"$bin/radlint" "$model" || status=$?
# Above 1 the run itself has failed.
if [ "$status" -gt 1 ]; then
  exit "$status"
fi
if [ "$status" = 1 ]; then
  echo "(exit code 1: there are faults; the bundled lamp post has them on purpose)"
fi

step "2. Repair, mesh, solve, bake" radfix "$model" -o "$lit" --solve --preview "$picture"
"$bin/radfix" "$model" -o "$lit" --solve --preview "$picture"

step "3. The result, judged again" radlint --stage display "$lit"
"$bin/radlint" --stage display "$lit"

cat <<END

The lit model is   $lit   (glTF: any viewer, or three.js)
Its picture is     $picture
The programs are   $bin/radlint and $bin/radfix
END
