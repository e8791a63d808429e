#!/usr/bin/env python3
"""Holds every #include of the project against the layers of cmake/layers.cmake.

usage: check_includes.py ROOT

A file of layer L may include headers of L and of the layers that L may use, and third parties only where they belong.
Exits 1 and names each line that breaks this.
"""
import pathlib
import re
import sys

THIRD_PARTY = {  # header prefix → layers that may name it
    "CGAL/": {"geom"},
    "draco/": {"readers", "writers"},
    "assimp/": {"readers"},
    "CLI/": {"cli"},
    "toml++/": {"config"},
    "xxhash.h": {"batch"},
    "nlohmann/": {"readers", "writers", "report", "cli", "corpus"},
    "boost/": {"geom", "repair"},
    "embree3/": {"mesh", "solve", "bake"},
    "Imf": {"mesh", "bake"},
    "stb/": {"bake"},
    "OpenMesh/": {"mesh"},
    "png.h": {"bake"},
    "zlib.h": {"report"},
}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def allowed_layers(root):
    table = {}
    for line in (root / "cmake/layers.cmake").read_text().splitlines():
        match = re.match(r"set\(RAD_ALLOWED_(\w+) \"?([^\")]*)\"?\)", line)
        if match:
            table[match[1]] = set(match[2].split()) | {match[1]}
    return table


def faults(root):
    table = allowed_layers(root)
    for layer in table:
        for path in sorted((root / layer).rglob("*")):
            if path.suffix not in {".h", ".cpp"}:
                continue
            for number, line in enumerate(path.read_text().splitlines(), 1):
                match = INCLUDE.match(line)
                if not match:
                    continue
                quoted, name = match[1] == '"', match[2]
                place = f"{path.relative_to(root)}:{number}"
                if quoted and name.split("/")[0] not in table[layer]:
                    yield f"{place}: layer '{layer}' may not include {name}"
                for prefix, layers in THIRD_PARTY.items():
                    if name.startswith(prefix) and layer not in layers:
                        yield f"{place}: {name} belongs to {', '.join(sorted(layers)) or 'no layer yet'}"


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    if len(allowed_layers(root)) < 6:
        print("cmake/layers.cmake: the table of layers was not found")
        return 1
    found = list(faults(root))
    print("\n".join(found) if found else "every include keeps to its layer")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
