#!/usr/bin/env python3
"""Compiles every header of the project alone, so that each includes what it needs.

usage: check_headers.py ROOT [COMPILER]
"""
import concurrent.futures
import pathlib
import subprocess
import sys

LAYERS = ("geom", "scene", "readers", "writers", "validate", "repair", "mesh", "solve", "bake", "report", "cli", "corpus")


def compiles(root, compiler, header):
    source = f'#include "{header.relative_to(root)}"\n#include "{header.relative_to(root)}"\n'
    command = [compiler, "-std=c++20", "-fsyntax-only", f"-I{root}", "-x", "c++", "-"]
    done = subprocess.run(command, input=source, capture_output=True, text=True)
    return header, done.returncode, done.stderr


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    compiler = sys.argv[2] if len(sys.argv) > 2 else "c++"
    headers = [h for layer in LAYERS for h in sorted((root / layer).rglob("*.h"))]
    if not headers:
        print("no headers found")
        return 1
    failed = 0
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for header, status, errors in pool.map(lambda h: compiles(root, compiler, h), headers):
            if status:
                failed += 1
                print(f"{header.relative_to(root)} does not compile alone:\n{errors[:600]}")
    print(f"{len(headers) - failed} of {len(headers)} headers compile alone")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
