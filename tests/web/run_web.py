#!/usr/bin/env python3
"""Runs a Node script of web/tests, or says what is missing for it and exits 77.

usage: run_web.py ROOT SCRIPT [ARGUMENT…]

SCRIPT is a file of web/tests; one that ends in _test.mjs is run by Node's test runner.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys

SKIPPED = 77


def missing(root):
    if shutil.which("node") is None:
        yield "node"
    package = json.loads((root / "web/package.json").read_text())
    for name in {**package["dependencies"], **package["devDependencies"]}:
        if not (root / "web/node_modules" / name).is_dir():
            yield f"web/node_modules/{name} (npm ci)"
    named = os.environ.get("RAD_CHROMIUM")
    if not (pathlib.Path(named).is_file() if named else shutil.which("chromium")):
        yield "chromium"


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    script, arguments = sys.argv[2], sys.argv[3:]
    absent = list(missing(root))
    if absent:
        print(f"skipped: {', '.join(absent)} not found")
        return SKIPPED
    runner = ["node", "--test"] if script.endswith("_test.mjs") else ["node"]
    return subprocess.run([*runner, root / "web/tests" / script, *arguments]).returncode


if __name__ == "__main__":
    sys.exit(main())
