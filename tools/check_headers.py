#!/usr/bin/env python3
"""Compiles every header of the project alone, so that each includes what it needs.

usage: check_headers.py ROOT [COMPILER] [--optional FOLDER=INCLUDES]...

Headers of an optional folder are compiled with that folder of includes, and passed over where it is empty: the library
that they need is not there.
"""
import argparse
import concurrent.futures
import pathlib
import subprocess
import sys

LAYERS = ("geom", "scene", "readers", "writers", "validate", "repair", "mesh", "solve", "bake", "report", "cli", "corpus")


def includes_of(root, header, optional):
    """What the header needs, None where it is not there."""
    for folder, includes in optional.items():
        if header.is_relative_to(root / folder):
            return ["-isystem", includes] if includes else None
    return []


def compiles(root, compiler, header, includes):
    source = f'#include "{header.relative_to(root)}"\n#include "{header.relative_to(root)}"\n'
    command = [compiler, "-std=c++20", "-fsyntax-only", f"-I{root}", *includes, "-x", "c++", "-"]
    done = subprocess.run(command, input=source, capture_output=True, text=True)
    return header, done.returncode, done.stderr


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("compiler", nargs="?", default="c++")
    parser.add_argument("--optional", action="append", default=[])
    words = parser.parse_args()
    root = words.root.resolve()
    optional = dict(word.split("=", 1) for word in words.optional)
    every = [h for layer in LAYERS for h in sorted((root / layer).rglob("*.h"))]
    headers = {h: includes_of(root, h, optional) for h in every}
    headers = {h: includes for h, includes in headers.items() if includes is not None}
    if not headers:
        print("no headers found")
        return 1
    failed = 0
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for header, status, errors in pool.map(lambda h: compiles(root, words.compiler, h, headers[h]), headers):
            if status:
                failed += 1
                print(f"{header.relative_to(root)} does not compile alone:\n{errors[:600]}")
    print(f"{len(headers) - failed} of {len(headers)} headers compile alone")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
