#!/usr/bin/env python3
"""Writes a folder of small models: tables with a lamp on them, no two alike, some with a face turned over.

usage: small_models.py FOLDER COUNT
"""
import pathlib
import sys


class Obj:
    def __init__(self):
        self.lines, self.vertices = [], 0

    def box(self, name, material, low, high, turned=False):
        self.lines += [f"o {name}", f"usemtl {material}"]
        for z in (low[2], high[2]):
            for x, y in ((low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1])):
                self.lines.append(f"v {x:.4f} {y:.4f} {z:.4f}")
        sides = [(4, 3, 2, 1), (5, 6, 7, 8), (1, 2, 6, 5), (2, 3, 7, 6), (3, 4, 8, 7), (4, 1, 5, 8)]
        if turned:
            sides[-1] = sides[-1][::-1]
        for side in sides:
            self.lines.append("f " + " ".join(str(self.vertices + corner) for corner in side))
        self.vertices += 8


def model(index):
    obj = Obj()
    obj.lines.append("mtllib room.mtl")
    size = 1 + index / 5000
    for i, (x, y) in enumerate(((0, 0), (size, 0), (size, size), (0, size))):
        obj.box(f"leg{i}", "oak", (x, y, 0), (x + 0.05, y + 0.05, 0.7))
    obj.box("top", "oak", (-0.1, -0.1, 0.75), (size + 0.2, size + 0.2, 0.8), turned=index % 3 == 0)
    obj.box("lamp", "lamp", (0.3, 0.3, 2), (0.5, 0.5, 2.1))
    return "\n".join(obj.lines) + "\n"


def main():
    folder, count = pathlib.Path(sys.argv[1]), int(sys.argv[2])
    for index in range(count):
        part = folder / f"{index % 20:02}"
        part.mkdir(parents=True, exist_ok=True)
        (part / f"{index:05}.obj").write_text(model(index))
        (part / "room.mtl").write_text("newmtl oak\nKd 0.4 0.3 0.2\nnewmtl lamp\nKd 0.5 0.5 0.5\nKe 10 10 10\n")


if __name__ == "__main__":
    main()
