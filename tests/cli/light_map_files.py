#!/usr/bin/env python3
"""Holds the light maps that radfix writes against each other and against the nodes, with readers of its own.

usage: light_map_files.py RADFIX MODEL [OPTION...]

Bakes MODEL as light map, as emissive map and onto vertices, and reads OpenEXR, PNG, GLB, glTF and PLY with nothing but
the standard library. Prints what it measures; exits 1 and names what does not hold.
"""
import json
import math
import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

SEAM = 0.01  # of the value, between what both charts of an edge show along it
NODES = 0.01  # of the root mean square, between the map at the vertices and the vertices
DARK = 0.01  # of the mean; below it differences are held against this
INTEGRAL = 0.005
CODES = 1  # of 255, between a PNG page and the OpenEXR page shown


def undo_predictor(data):
    out = bytearray(data)
    for i in range(1, len(out)):
        out[i] = (out[i - 1] + out[i] - 128) & 255
    half = (len(out) + 1) // 2
    mixed = bytearray(len(out))
    mixed[0::2] = out[:half]
    mixed[1::2] = out[half:]
    return bytes(mixed)


def attributes_of(data):
    at, found = 8, {}

    def text():
        nonlocal at
        end = data.index(b"\0", at)
        word = data[at:end].decode()
        at = end + 1
        return word

    while name := text():
        kind, (size,) = text(), struct.unpack_from("<i", data, at)
        found[name] = (kind, data[at + 4:at + 4 + size])
        at += 4 + size
    return found, at


def channels_of(value):
    at, channels = 0, []
    while value[at]:
        end = value.index(b"\0", at)
        (kind,) = struct.unpack_from("<i", value, end + 1)
        channels.append((value[at:end].decode(), kind))
        at = end + 17
    return channels


class Exr:
    """Scan lines under ZIP, half and float, as the file layout of OpenEXR says."""

    def __init__(self, path):
        data = path.read_bytes()
        assert struct.unpack_from("<ii", data) == (20000630, 2), path
        self.attributes, at = attributes_of(data)
        x0, y0, x1, y1 = struct.unpack("<4i", self.attributes["dataWindow"][1])
        assert (x0, y0) == (0, 0) and self.attributes["compression"][1] == b"\3"
        assert self.attributes["lineOrder"][1] == b"\0"
        self.width, self.height = x1 + 1, y1 + 1
        self.channels = channels_of(self.attributes["channels"][1])
        self.planes = {name: [] for name, _ in self.channels}
        chunks = (self.height + 15) // 16
        for (offset,) in struct.iter_unpack("<Q", data[at:at + 8 * chunks]):
            self.read_chunk(data, offset)

    def read_chunk(self, data, offset):
        y, size = struct.unpack_from("<ii", data, offset)
        packed = data[offset + 8:offset + 8 + size]
        lines = min(16, self.height - y)
        row_bytes = sum(self.width * (2 if kind == 1 else 4) for _, kind in self.channels)
        raw = packed if size == lines * row_bytes else undo_predictor(zlib.decompress(packed))
        assert len(raw) == lines * row_bytes
        at = 0
        for _ in range(lines):
            for name, kind in self.channels:
                size = self.width * (2 if kind == 1 else 4)
                self.planes[name].extend(struct.unpack(f"<{self.width}{'e' if kind == 1 else 'f'}", raw[at:at + size]))
                at += size

    def text(self, name):
        kind, value = self.attributes[name]
        assert kind == "string"
        return value.decode()

    def at(self, x, y):
        i = y * self.width + x
        return [self.planes[channel][i] for channel in "RGB"]


def paeth(a, b, c):
    p = a + b - c
    pa, pb, pc = abs(p - a), abs(p - b), abs(p - c)
    return a if pa <= pb and pa <= pc else b if pb <= pc else c


def png_codes(data):
    """Width, height and 8-bit RGB of a PNG without interlacing."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at, packed, head = 8, b"", None
    while at < len(data):
        (size,), kind = struct.unpack_from(">I", data, at), data[at + 4:at + 8]
        body = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            head = struct.unpack(">IIBBBBB", body)
        elif kind == b"IDAT":
            packed += body
        at += 12 + size
    width, height = head[:2]
    assert head[2:] == (8, 2, 0, 0, 0)
    raw, stride = zlib.decompress(packed), 3 * width
    rows, before = [], bytearray(stride)
    for y in range(height):
        kind = raw[y * (stride + 1)]
        row = bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            left, up, corner = (row[i - 3] if i >= 3 else 0), before[i], (before[i - 3] if i >= 3 else 0)
            row[i] = (row[i] + (0, left, up, (left + up) // 2, paeth(left, up, corner))[kind]) & 255
        rows.append(row)
        before = row
    return width, height, rows


def srgb(linear):
    value = min(max(linear, 0), 1)
    return 255 * (12.92 * value if value <= 0.0031308 else 1.055 * value ** (1 / 2.4) - 0.055)


def glb_parts(path):
    data = path.read_bytes()
    (size,) = struct.unpack_from("<I", data, 12)
    return json.loads(data[20:20 + size]), data[28 + size:]


class Gltf:
    def __init__(self, document, buffer):
        self.document, self.buffer = document, buffer

    def block(self, view):
        entry = self.document["bufferViews"][view]
        return self.buffer[entry["byteOffset"]:entry["byteOffset"] + entry["byteLength"]]

    def floats(self, accessor):
        entry = self.document["accessors"][accessor]
        assert entry["componentType"] == 5126
        count = {"VEC2": 2, "VEC3": 3}[entry["type"]]
        raw = self.block(entry["bufferView"])[entry["byteOffset"]:entry["byteOffset"] + 4 * count * entry["count"]]
        return list(struct.iter_unpack(f"<{count}f", raw))

    def indices(self, accessor):
        entry = self.document["accessors"][accessor]
        kind, size = {5123: ("H", 2), 5125: ("I", 4)}[entry["componentType"]]
        raw = self.block(entry["bufferView"])[entry["byteOffset"]:entry["byteOffset"] + size * entry["count"]]
        return [i for (i,) in struct.iter_unpack(f"<{kind}", raw)]

    def lit_primitives(self):
        """Of each: what radfix records of its material, indices, and positions, radiosity and places on the page."""
        for primitive in (p for mesh in self.document["meshes"] for p in mesh["primitives"]):
            attributes = primitive["attributes"]
            yield (self.document["materials"][primitive["material"]]["extras"]["radfix"],
                   self.indices(primitive["indices"]),
                   *(self.floats(attributes[name]) for name in ("POSITION", "_RADIOSITY", "TEXCOORD_1")))


def ply_integral(path):
    """Of B over the faces of a binary PLY, and of 1; quadrilaterals as the mean of both ways to cut them."""
    data = path.read_bytes()
    head, body = data.split(b"end_header\n", 1)
    lines = [line.split() for line in head.decode().splitlines()]
    counts = {words[1]: int(words[2]) for words in lines if words[0] == "element"}
    assert b"format binary_little_endian" in head
    layout = "<" + "".join({"double": "d", "uchar": "B"}[words[1]] for words in lines
                           if words[0] == "property" and words[1] != "list")
    names = [words[2] for words in lines if words[0] == "property" and words[1] != "list"]
    assert names[:6] == ["x", "y", "z", "B_r", "B_g", "B_b"], names
    at, total, area = struct.calcsize(layout) * counts["vertex"], [0.0] * 3, 0.0
    vertices = [vertex[:6] for vertex in struct.iter_unpack(layout, body[:at])]
    for _ in range(counts["face"]):
        count = body[at]
        corners = struct.unpack_from(f"<{count}i", body, at + 1)
        at += 1 + 4 * count
        ways = [((0, 1, 2), 1)] if count == 3 else [((0, 1, 2), .5), ((0, 2, 3), .5), ((0, 1, 3), .5), ((1, 2, 3), .5)]
        for triangle, share in ways:
            a, b, c = (vertices[corners[i]] for i in triangle)
            u, v = [b[i] - a[i] for i in range(3)], [c[i] - a[i] for i in range(3)]
            cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
            size = share * math.sqrt(sum(x * x for x in cross)) / 2
            area += size
            for channel in range(3):
                total[channel] += size * (a[3 + channel] + b[3 + channel] + c[3 + channel]) / 3
    return total, area


def map_integral(atlas, pages):
    total, area = [0.0] * 3, 0.0
    for chart in atlas["charts"]:
        page, size = pages[chart["page"]], chart["texel"][0] * chart["texel"][1]
        for y in range(chart["y"], chart["y"] + chart["height"]):
            for i in range(y * page.width + chart["x"], y * page.width + chart["x"] + chart["width"]):
                share = page.planes["coverage"][i] * size
                area += share
                for channel in range(3):
                    total[channel] += share * page.planes["RGB"[channel]][i]
    return total, area


def bilinear(page, u, v):
    x, y = u * page.width - 0.5, v * page.height - 0.5
    column, row = math.floor(x), math.floor(y)
    value = [0.0] * 3
    for down in (0, 1):
        for right in (0, 1):
            weight = (x - column if right else 1 - x + column) * (y - row if down else 1 - y + row)
            if weight:
                value = [a + weight * b for a, b in zip(value, page.at(column + right, row + down))]
    return value


class Checks:
    def __init__(self, radfix, model, options):
        self.radfix, self.model, self.options, self.faults = radfix, model, options, []

    def hold(self, what, holds):
        print(("ok   " if holds else "FAIL ") + what)
        if not holds:
            self.faults.append(what)

    def run(self, output, *options):
        subprocess.run([self.radfix, self.model, "-o", output, "--solve", *self.options, *options], check=True,
                       stdout=subprocess.DEVNULL)

    def header(self, exr, atlas):
        self.hold("the header says what the page holds",
                  exr.text("quantity") == atlas["quantity"] and exr.text("units") == "W/m2"
                  and exr.text("software").startswith("radfix ")
                  and {kind for name, kind in exr.channels if name in "RGB"} == {1 if atlas["precision"] == "half" else 2})
        primaries = struct.unpack("<8f", exr.attributes["chromaticities"][1])
        wanted = (0.64, 0.33, 0.30, 0.60, 0.15, 0.06, 0.3127, 0.3290)
        self.hold("chromaticities are those of sRGB", all(abs(a - b) < 1e-4 for a, b in zip(primaries, wanted)))

    def shown(self, atlas, pages, pngs):
        worst = 0
        for chart in atlas["charts"]:
            white, page, rows = chart["white"], pages[chart["page"]], pngs[chart["page"]]
            for y in range(chart["y"], chart["y"] + chart["height"]):
                for x in range(chart["x"], chart["x"] + chart["width"]):
                    for channel, value in enumerate(page.at(x, y)):
                        worst = max(worst, abs(rows[y][3 * x + channel] - srgb(value / white)))
        self.hold(f"PNG pages show the OpenEXR pages, within {worst:.2f} codes", worst <= CODES)

    def vertices(self, gltf, pages):
        off, all_of_it, count = 0, 0, 0
        for record, indices, _, nodes, places in gltf.lit_primitives():
            for i in sorted(set(indices)):
                count += 1
                shown = bilinear(pages[record["lightMap"]], *places[i])
                off += sum((a - b) ** 2 for a, b in zip(shown, nodes[i]))
                all_of_it += sum(b ** 2 for b in nodes[i])
        share = math.sqrt(off / all_of_it)
        self.hold(f"at {count} vertices the map shows the node within {100 * share:.2g} % of the root mean square",
                  share < NODES)

    def seams(self, gltf, pages):
        """Edges whose ends have one radiosity in two charts: what both show at nine points along them."""
        sides = {}
        for record, indices, points, nodes, places in gltf.lit_primitives():
            for i in range(0, len(indices), 3):
                for a, b in zip(indices[i:i + 3], indices[i + 1:i + 3] + indices[i:i + 1]):
                    (p, m, s), (q, n, t) = sorted([(points[a], nodes[a], places[a]), (points[b], nodes[b], places[b])])
                    sides.setdefault((p, q, m, n), set()).add((record["lightMap"], s, t))
        seams = [sorted(places) for places in sides.values() if len(places) > 1]
        mean = sum(sum(page.planes["G"]) for page in pages) / max(1, sum(sum(page.planes["coverage"]) for page in pages))
        worst = 0
        for seam in seams:
            for step in range(9):
                shown = [bilinear(pages[page], *(a + (b - a) * step / 8 for a, b in zip(s, t))) for page, s, t in seam]
                for channel in zip(*shown):
                    worst = max(worst, (max(channel) - min(channel)) / max(*channel, DARK * mean))
        self.hold(f"along {len(seams)} edges both charts show the same within {100 * worst:.2g} %",
                  worst < SEAM and len(seams) > 0)

    def materials(self, gltf, atlas, emissive):
        for material in gltf.document["materials"]:
            extensions = material["extensions"]
            if emissive:
                names = [entry["name"] for entry in atlas["materials"]]
                whites = {c["whiteLuminance"] for c in atlas["charts"] if names[c["material"]] == material["name"]}
                strength = extensions["KHR_materials_emissive_strength"]["emissiveStrength"]
                good = (material["emissiveTexture"]["texCoord"] == 1 and material["emissiveFactor"] == [1, 1, 1]
                        and any(math.isclose(strength, white) for white in whites)
                        and material["pbrMetallicRoughness"]["baseColorFactor"] == [0, 0, 0, 1])
            else:
                good = (material["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"] == 1
                        and "KHR_materials_unlit" in extensions)
            self.hold(f"material {material['name']} shows the map", good)

    def bake(self, folder, mode):
        model = folder / f"{mode}.glb"
        self.run(model, "--bake", mode)
        atlas = json.loads((folder / f"{mode}.atlas.json").read_text())
        pages = [Exr(folder / page["exr"]) for page in atlas["pages"]]
        pngs = [png_codes((folder / page["png"]).read_bytes()) for page in atlas["pages"]]
        sizes = [(page["width"], page["height"]) for page in atlas["pages"]]
        self.hold(f"{mode}: {len(pages)} page(s) of {sizes}, texels of {atlas['texel']:.4g}, {len(atlas['charts'])} charts",
                  sizes == [(p.width, p.height) for p in pages] == [p[:2] for p in pngs])
        gltf = Gltf(*glb_parts(model))
        images = [gltf.block(image["bufferView"]) for image in gltf.document["images"]]
        self.hold("the model has the PNG pages in it",
                  images == [(folder / page["png"]).read_bytes() for page in atlas["pages"]])
        self.header(pages[0], atlas)
        self.shown(atlas, pages, [rows for _, _, rows in pngs])
        self.vertices(gltf, pages)
        self.seams(gltf, pages)
        self.materials(gltf, atlas, mode == "emissive")
        return atlas, pages

    def all(self, folder):
        atlas, pages = self.bake(folder, "lightmap")
        self.run(folder / "nodes.ply")
        (nodes, node_area), (shown, map_area) = ply_integral(folder / "nodes.ply"), map_integral(atlas, pages)
        off = max(abs(a - b) / b for a, b in zip(shown, nodes))
        self.hold(f"the integral over the map is that over the nodes within {100 * off:.3g} %", off < INTEGRAL)
        self.hold(f"coverage sums to the area, within {abs(map_area / node_area - 1):.2g}",
                  abs(map_area / node_area - 1) < 1e-3)
        self.bake(folder, "emissive")
        self.twin(folder)
        self.more_pages(folder, atlas)
        self.threads(folder)

    def twin(self, folder):
        self.run(folder / "twin.glb", "--bake", "lightmap", "--draco")
        plain, packed = (Gltf(*glb_parts(folder / name)) for name in ("twin.glb", "twin.draco.glb"))
        images = [[g.block(image["bufferView"]) for image in g.document["images"]] for g in (plain, packed)]
        self.hold("the compressed twin has the same pages", images[0] == images[1])
        sets = [p["extensions"]["KHR_draco_mesh_compression"]["attributes"].keys()
                for mesh in packed.document["meshes"] for p in mesh["primitives"]]
        self.hold("and the texture coordinates of the map", all("TEXCOORD_1" in names for names in sets))

    def more_pages(self, folder, atlas):
        small = max(64, max(page["width"] for page in atlas["pages"]) // 2)
        longest = max(max(chart["width"], chart["height"]) for chart in atlas["charts"])
        texel = atlas["texel"] * max(1.01, longest / (small - 8))
        self.run(folder / "more.gltf", "--bake", "lightmap", "--page-size", str(small), "--texel", str(texel),
                 "--store", "E")
        more = json.loads((folder / "more.atlas.json").read_text())
        document = json.loads((folder / "more.gltf").read_text())
        self.hold(f"pages of at most {small} texels: {len(more['pages'])} of them",
                  len(more["pages"]) > 1 and max(page["width"] for page in more["pages"]) <= small)
        self.hold("a .gltf names the pages beside it",
                  [image["uri"] for image in document["images"]] == [page["png"] for page in more["pages"]])
        pages = [Exr(folder / page["exr"]) for page in more["pages"]]
        self.header(pages[0], more)
        document_of = Gltf(document, (folder / document["buffers"][0]["uri"]).read_bytes())
        self.irradiance(document_of, pages)

    def irradiance(self, gltf, pages):
        off, all_of_it = 0, 0
        for record, indices, _, nodes, places in gltf.lit_primitives():
            for i in sorted(set(indices)):
                incident = bilinear(pages[record["lightMap"]], *places[i])
                for e, b, m, r in zip(incident, nodes[i], record["exitance"], record["reflectance"]):
                    off += (m + r * e - b) ** 2
                    all_of_it += b ** 2
        share = math.sqrt(off / all_of_it)
        self.hold(f"emission + reflectance x E is the radiosity, within {100 * share:.2g} % of the root mean square",
                  share < NODES)

    def threads(self, folder):
        for jobs in ("1", "2"):
            (folder / jobs).mkdir()
            self.run(folder / jobs / "out.glb", "--bake", "lightmap", "--jobs", jobs)
        one, two = ({p.name: p.read_bytes() for p in sorted((folder / jobs).iterdir())} for jobs in ("1", "2"))
        self.hold(f"one and two threads write the same bytes in {len(one)} files", one == two and len(one) >= 4)


def main():
    radfix, model, *options = sys.argv[1:]
    checks = Checks(radfix, model, options)
    with tempfile.TemporaryDirectory() as folder:
        checks.all(pathlib.Path(folder))
    return 1 if checks.faults else 0


if __name__ == "__main__":
    sys.exit(main())
