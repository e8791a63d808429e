#!/usr/bin/env python3
"""Makes the house and the theatre, meshes them, and prints what came of it beside Table 3 of the paper.

usage: table3.py BIN [--keep DIR] [--pmesh graded|grid]

BIN is the folder with rad_corpus, radfix and radlint. Exits 1 where a written mesh has errors.
"""
import argparse
import json
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

# Patch and element lengths in metres with which the models come near the paper's counts.
SIZES = {"house": ("0.25", "0.125"), "theatre": ("0.3", "0.1")}
PAPER = {
    "house": {"surfaces": "8 623", "patches": "68 186", "elements": "420 026", "grouper": "167", "isect": "143",
              "pmesh": "390", "emesh": "5"},
    "theatre": {"surfaces": "5 276", "patches": "78 094", "elements": "1 061 543", "grouper": "170", "isect": "241",
                "pmesh": "1 553", "emesh": "32 + 220 a light"},
}
ROWS = ["surfaces", "patches", "elements", "grouper", "isect", "coplanar", "pmesh", "emesh", "all, s", "peak, MiB",
        "bytes an element", "shape: median", "shape: 1st percentile", "errors when read back"]


def grouped(number):
    return f"{number:,}".replace(",", " ")


def measure(folder, binaries, name, pmesh):
    model = folder / f"{name}.obj"
    subprocess.run([binaries / "rad_corpus", name, model], check=True)
    surfaces = sum(line.startswith("f ") for line in model.open())
    patch, element = SIZES[name]
    report = folder / f"{name}.json"
    start = time.monotonic()
    run = subprocess.run(
        [binaries / "radfix", model, "-o", folder / f"{name}_mesh.ply", "--mesh", "--patch-size", patch, "--element-size",
         element, "--pmesh", pmesh, "--timings", "--report", f"json={report}"], stdout=subprocess.DEVNULL)
    seconds = time.monotonic() - start
    peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
    found = json.loads(report.read_text())
    mesh, timings = found["mesh"], found["timings"]
    figures = {"surfaces": grouped(surfaces), "patches": grouped(mesh["patches"]), "elements": grouped(mesh["elements"]),
               "all, s": f"{seconds:.1f}", "peak, MiB": f"{peak:.0f}",
               "bytes an element": f"{mesh['bytesPerElement']:.0f}",
               "shape: median": f"{mesh['shape']['blunt']['median']:.3f}",
               "shape: 1st percentile": f"{mesh['shape']['blunt']['firstPercentile']:.3f}",
               "errors when read back": str(found["after"]["errors"] if found["after"] else "-")}
    for stage in ("grouper", "isect", "coplanar", "pmesh", "emesh"):
        if stage in timings:
            figures[stage] = f"{timings[stage]:.2f}"
    return figures, run.returncode


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("bin", type=pathlib.Path)
    parser.add_argument("--keep", type=pathlib.Path)
    parser.add_argument("--pmesh", default="graded", choices=["graded", "grid"])
    args = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        folder = args.keep or pathlib.Path(scratch)
        folder.mkdir(parents=True, exist_ok=True)
        results = {name: measure(folder, args.bin.resolve(), name, args.pmesh) for name in SIZES}
    print(f"{'':24}{'house':>14}{'in the paper':>18}{'theatre':>14}{'in the paper':>18}")
    for row in ROWS:
        cells = [row.ljust(24)]
        for name in SIZES:
            cells += [results[name][0].get(row, "").rjust(14), PAPER[name].get(row, "").rjust(18)]
        print("".join(cells).rstrip())
    return max(code for _, code in results.values())


if __name__ == "__main__":
    sys.exit(main())
