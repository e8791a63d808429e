#!/usr/bin/env python3
"""tools/new_rule.py on a copy of what it reads: what it adds, where, and what it refuses."""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

PROJECT = pathlib.Path(__file__).resolve().parents[2]
TITLE = "A fault of a test"


class NewRule(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        shutil.copytree(PROJECT / "validate", self.root / "validate")
        shutil.copy(PROJECT / "CHANGELOG.md", self.root)

    def start(self, *words):
        command = [sys.executable, PROJECT / "tools/new_rule.py", *words, "--root", self.root]
        return subprocess.run(command, capture_output=True, text=True)

    def text(self, path):
        return (self.root / path).read_text()

    def test_adds_source_and_fixtures(self):
        self.assertEqual(self.start("RL199", "some-fault", "1a", TITLE).returncode, 0)
        source = self.text("validate/rules/some_fault.cpp")
        self.assertIn('.id = "RL199"', source)
        self.assertIn("Requirement::SolidModel", source)
        folder = "corpus/rules/RL199-some-fault"
        self.assertTrue(self.text(f"{folder}/fail.obj").startswith(f"# {TITLE}.\n"))
        self.assertEqual(set(json.loads(self.text(f"{folder}/expected.json"))), {"fail.obj", "pass.obj"})

    def test_lists_the_rule_at_its_level_and_nothing_else_changes(self):
        rules = self.text("validate/rules.def").splitlines()
        self.start("RL199", "some-fault", "1a", TITLE)
        longer = self.text("validate/rules.def").splitlines()
        at = longer.index("RAD_RULE(some_fault)")
        self.assertEqual(longer[:at] + longer[at + 1:], rules)
        self.assertIn('.id = "RL1', self.text(f"validate/rules/{longer[at - 1][9:-1]}.cpp"))
        self.assertIn('.id = "RL2', self.text(f"validate/rules/{longer[at + 1][9:-1]}.cpp"))

    def test_lists_the_highest_rule_last(self):
        self.start("RL999", "last-fault", "units", TITLE)
        self.assertTrue(self.text("validate/rules.def").endswith("RAD_RULE(last_fault)\n"))

    def test_adds_one_line_to_the_newest_version(self):
        (self.root / "CHANGELOG.md").write_text("# Changelog\n\n## 2\n\n- new\n\n## 1\n\n- old\n")
        self.start("RL199", "some-fault", "1a", TITLE)
        expected = "# Changelog\n\n## 2\n\n- new\n- **validate**: RL199 `some-fault`.\n\n## 1\n\n- old\n"
        self.assertEqual(self.text("CHANGELOG.md"), expected)

    def test_refuses_and_writes_nothing(self):
        for words in (
            ("RL201", "some-fault", "2a", TITLE),
            ("RL199", "t-vertex", "2a", TITLE),
            ("RL19", "some-fault", "2a", TITLE),
            ("RL199", "no-fault", "2a", TITLE),
            ("RL199", "Some_Fault", "2a", TITLE),
            ("RL199", "some-fault", "9z", TITLE),
            ("RL199", "some-fault", "2a", TITLE + "."),
        ):
            before = {path: path.read_bytes() for path in self.root.rglob("*") if path.is_file()}
            result = self.start(*words)
            self.assertEqual(result.returncode, 2, words)
            self.assertIn("new_rule.py: ", result.stderr)
            after = {path: path.read_bytes() for path in self.root.rglob("*") if path.is_file()}
            self.assertEqual(after, before, words)

    def test_refuses_where_a_file_is_in_the_way(self):
        (self.root / "validate/rules/some_fault.cpp").write_text("mine")
        result = self.start("RL199", "some-fault", "1a", TITLE)
        self.assertEqual(result.returncode, 2)
        self.assertIn("validate/rules/some_fault.cpp is in the way", result.stderr)
        self.assertEqual(self.text("validate/rules/some_fault.cpp"), "mine")


if __name__ == "__main__":
    unittest.main()
