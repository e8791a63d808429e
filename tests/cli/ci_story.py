#!/usr/bin/env python3
"""radlint and radfix in a pipeline, from the first red run to the comment on a pull request.

usage: ci_story.py RADLINT RADFIX MODELS

Lints a folder with reports for a code host and a build server, accepts what is there with a baseline, writes the models
down anew in other orders and formats, plants a fault, repairs it, and compares.
"""
import json
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile
import unittest

import junitparser

RADLINT, RADFIX, MODELS = (pathlib.Path(word).resolve() for word in sys.argv[1:4])


def shuffled_obj(text, seed):
    """The same OBJ with vertices renumbered and faces in another order; objects and materials stay with their faces."""
    chance = random.Random(seed)
    head, vertices, faces = [], [], []
    state = {}
    for line in text.splitlines():
        word = line.split(" ", 1)[0]
        if word == "v":
            vertices.append(line)
        elif word == "f":
            faces.append((state.get("o", "o none"), state.get("usemtl", "usemtl none"), line))
        elif word in ("o", "usemtl"):
            state[word] = line
        else:
            head.append(line)
    order = list(range(len(vertices)))
    chance.shuffle(order)
    number = {old: new for new, old in enumerate(order, 1)}
    chance.shuffle(faces)
    out = head + [vertices[i] for i in order]
    for name, material, face in faces:
        corners = [str(number[int(corner) - 1]) for corner in face.split()[1:]]
        start = chance.randrange(len(corners))
        out += [name, material, "f " + " ".join(corners[start:] + corners[:start])]
    return "\n".join(out) + "\n"


class Story(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.models = self.root / "models"
        shutil.copytree(MODELS, self.models)

    def run_tool(self, tool, *words, exit_code):
        done = subprocess.run([tool, *map(str, words)], capture_output=True, text=True, cwd=self.root)
        self.assertEqual(done.returncode, exit_code, f"{tool.name} {' '.join(map(str, words))}\n{done.stdout}{done.stderr}")
        return done.stdout

    def lint(self, *words, exit_code):
        return json.loads(self.run_tool(RADLINT, *words, "--format", "json", "--max-issues", 0, exit_code=exit_code))

    def diff(self, old, new, exit_code):
        return json.loads(self.run_tool(RADLINT, "diff", old, new, "--format", "json", exit_code=exit_code))

    def shuffle_models(self, seed):
        for path in self.models.glob("*.obj"):
            path.write_text(shuffled_obj(path.read_text(), seed))

    def export_models(self, suffix):
        """In another format, unrepaired; the OBJ files are gone."""
        for path in self.models.glob("*.obj"):
            words = [path, "-o", path.with_suffix(suffix), "--skip", "repair"]
            subprocess.run([RADFIX, *words], capture_output=True, cwd=self.root)
            self.assertTrue(path.with_suffix(suffix).exists(), path)
            path.unlink()

    def plant_flip(self, name):
        path = self.models / name
        lines = path.read_text().splitlines()
        last = max(i for i, line in enumerate(lines) if line.startswith("f "))
        lines[last] = "f " + " ".join(reversed(lines[last].split()[1:]))
        path.write_text("\n".join(lines) + "\n")

    def test_reports_agree(self):
        report = self.lint("models", "--report", "sarif=lint.sarif", "--report", "junit=lint.xml", exit_code=1)
        sarif = json.loads((self.root / "lint.sarif").read_text())
        results = sarif["runs"][0]["results"]
        self.assertEqual(len(results), len(report["findings"]))
        self.assertEqual(sum(result["level"] == "error" for result in results), report["summary"]["errors"])
        for result in results:
            uri = result["locations"][0]["physicalLocation"]["artifactLocation"]["uri"]
            self.assertTrue((self.root / uri).exists(), uri)
        suites = junitparser.JUnitXml.fromfile(str(self.root / "lint.xml"))
        self.assertEqual(len(suites), len(report["inputs"]))
        self.assertEqual(suites.tests, sum(len(list(suite)) for suite in suites))
        cases = [(suite.name, case) for suite in suites for case in suite]
        failed = {(name, case.name[:5]) for name, case in cases if any(isinstance(r, junitparser.Failure) for r in case.result)}
        self.assertEqual(suites.failures, len(failed))
        errors = {(f["where"]["file"], f["rule"]) for f in report["findings"] if f["severity"] == "error"}
        self.assertEqual(failed, errors)

    def test_baseline_from_red_to_green_to_red_to_green(self):
        self.lint("models", exit_code=1)
        self.lint("models", "--write-baseline", "known.json", exit_code=0)
        known = self.lint("models", "--baseline", "known.json", exit_code=0)["summary"]["known"]
        self.assertGreater(known, 0)
        for seed in range(3):
            self.shuffle_models(seed)
            summary = self.lint("models", "--baseline", "known.json", exit_code=0)["summary"]
            self.assertEqual((summary["errors"], summary["warnings"], summary["known"]), (0, 0, known))
        shutil.copytree(self.models, self.root / "before")

        self.plant_flip("two_room_flat.obj")
        report = self.lint("models", "--baseline", "known.json", exit_code=1)
        self.assertEqual([(f["rule"], f["baseline"]) for f in report["findings"] if f["severity"] == "error"], [("RL110", "new")])
        self.assertEqual(report["summary"]["errors"], 1)
        diff = self.diff("before", "models", exit_code=1)
        self.assertEqual((diff["summary"]["new"], diff["summary"]["fixed"]), (1, 0))

        shutil.copytree(self.models, self.root / "broken")
        flat = self.models / "two_room_flat.obj"
        self.run_tool(RADFIX, flat, "-o", flat.with_name("fixed.obj"), exit_code=0)
        flat.with_name("fixed.obj").replace(flat)
        self.lint("models", "--baseline", "known.json", exit_code=0)
        markdown = self.run_tool(RADLINT, "diff", "broken", "models", "--format", "markdown", exit_code=0)
        self.assertTrue(markdown.startswith("<!-- radlint-diff -->\n## radlint: pass\n"), markdown)
        self.assertIn("| RL110 `normal-inconsistent` |", markdown)
        self.assertIn("\n#### Fixed\n", markdown)

    def test_baseline_outlives_formats(self):
        self.lint("models", "--write-baseline", "known.json", exit_code=0)
        for suffix in (".ply", ".glb"):
            with self.subTest(suffix):
                shutil.rmtree(self.models)
                shutil.copytree(MODELS, self.models)
                self.shuffle_models(7)
                self.export_models(suffix)
                report = self.lint("models", "--baseline", "known.json", exit_code=0)
                self.assertEqual(report["summary"]["errors"], 0)

    def test_stale_entries_are_named_and_pruned(self):
        self.lint("models", "--write-baseline", "known.json", exit_code=0)
        lamp = self.models / "lamp_post.obj"
        self.run_tool(RADFIX, lamp, "-o", lamp.with_name("fixed.obj"), exit_code=0)
        lamp.with_name("fixed.obj").replace(lamp)
        report = self.lint("models", "--baseline", "known.json", exit_code=0)
        self.assertIn("RL904", report["summary"]["byRule"])
        self.lint("models", "--baseline", "known.json", "--strict-baseline", exit_code=1)
        self.lint("models", "--baseline", "known.json", "--prune-baseline", exit_code=0)
        report = self.lint("models", "--baseline", "known.json", "--strict-baseline", exit_code=0)
        self.assertNotIn("RL904", report["summary"]["byRule"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
