#!/usr/bin/env python3
"""Starts a rule: its source, its line in validate/rules.def, its fixture folder and its line in CHANGELOG.md.

usage: new_rule.py ID ALIAS REQUIREMENT TITLE [--root FOLDER]

example: new_rule.py RL103 nonmanifold-vertex 1a "Fans of faces touch in one vertex only"

The words of the rule are left empty and both fixtures hold the same clean tetrahedron, so the rule matrix fails until
the rule is written. docs/writing-rules.md says what each part is for. Nothing is written where anything is in the way.
"""
import argparse
import json
import pathlib
import re
import sys

REQUIREMENTS = {  # code of a requirement → enumerator in validate/rule.h
    "1a": "SolidModel",
    "1b": "NormalConsistency",
    "1c": "MaximalPlanarFaces",
    "2a": "NoTVertices",
    "2b": "NoImplicitIntersections",
    "2c": "NoOverlappingFaces",
    "2d": "SimpleFaces",
    "2e": "WellShapedFaces",
    "2f": "RadiatorDensity",
    "2g": "ReceiverDensity",
    "3a": "Ziplocking",
    "input": "Input",
    "materials": "Materials",
    "units": "Units",
}

SOURCE = """\
#include "validate/context.h"
#include "validate/rules.h"

namespace rad::validate {{
namespace {{

void check(const Context&, Violations&) {{}}

}}  // namespace

constinit const Rule {name}{{
    .id = "{id}",
    .alias = "{alias}",
    .title = {title},
    .message = "",
    .requirement = Requirement::{requirement},
    .fix = scene::FixClass::Manual,
    .citation = "",
    .doc = {{.what = "", .why = "", .how = "", .fix = "", .modeller = "", .limits = ""}},
    .check = &check,
}};

}}  // namespace rad::validate
"""

MODEL = """\
# {comment}
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
o one
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
"""

EXPECTED = """\
{
  "fail.obj": {
    "findings": [
      {"severity": "error", "count": 1, "point": [0, 0, 0]}
    ],
    "implied": []
  },
  "pass.obj": {
    "implied": []
  }
}
"""

RULE_ID = re.compile(r"RL[0-9]{3}")
ALIAS = re.compile(r"[a-z][a-z0-9]*(-[a-z0-9]+)*")
LISTED = re.compile(r"RAD_RULE\((\w+)\)")


class Refused(Exception):
    """Why no rule was started, as a sentence for the one who asked."""


def rules_of(root):
    """(id, alias, name) of every rule, in the order of rules.def."""
    rules = []
    for name in LISTED.findall((root / "validate/rules.def").read_text()):
        text = (root / f"validate/rules/{name}.cpp").read_text()
        rules.append((re.search(r'\.id = "(\w+)"', text)[1], re.search(r'\.alias = "([\w-]+)"', text)[1], name))
    return rules


def hold_against_rules(wanted, rules):
    if not RULE_ID.fullmatch(wanted.id):
        raise Refused(f"'{wanted.id}' is not an id: RL and three digits")
    if not ALIAS.fullmatch(wanted.alias) or wanted.alias.startswith("no-"):
        raise Refused(f"'{wanted.alias}' is not an alias: lower case words with hyphens that name the fault")
    if not wanted.title.strip() or wanted.title.strip().endswith("."):
        raise Refused("the title is one clause without a full stop")
    for rule_id, alias, _ in rules:
        if wanted.id == rule_id or wanted.alias == alias:
            raise Refused(f"{rule_id} {alias} is there already")


def with_list_entry(text, wanted, name, rules):
    """rules.def with the new line before the first rule of a higher id."""
    entry = f"RAD_RULE({name})\n"
    for rule_id, _, other in rules:
        if rule_id > wanted.id:
            return text.replace(f"RAD_RULE({other})\n", entry + f"RAD_RULE({other})\n")
    return text + entry


def with_change(text, wanted):
    """CHANGELOG.md with a new line at the end of the newest version."""
    lines = text.splitlines()
    versions = [i for i, line in enumerate(lines) if line.startswith("## ")]
    if not versions:
        raise Refused("CHANGELOG.md has no version to add a line to")
    end = versions[1] if len(versions) > 1 else len(lines)
    while not lines[end - 1].strip():
        end -= 1
    first_item = [""] if end - 1 == versions[0] else []
    lines[end:end] = first_item + [f"- **validate**: {wanted.id} `{wanted.alias}`."]
    return "\n".join(lines) + "\n"


def files_of(root, wanted):
    """What is to be written, by path: new files, and the two lists with a line more."""
    rules = rules_of(root)
    hold_against_rules(wanted, rules)
    name = wanted.alias.replace("-", "_")
    source = SOURCE.format(name=name, id=wanted.id, alias=wanted.alias, requirement=REQUIREMENTS[wanted.requirement],
                           title=json.dumps(wanted.title.strip(), ensure_ascii=False))
    folder = root / f"corpus/rules/{wanted.id}-{wanted.alias}"
    new = {
        root / f"validate/rules/{name}.cpp": source,
        folder / "fail.obj": MODEL.format(comment=wanted.title.strip() + "."),
        folder / "pass.obj": MODEL.format(comment="The nearest good neighbour."),
        folder / "expected.json": EXPECTED,
    }
    for path in new:
        if path.exists():
            raise Refused(f"{path.relative_to(root)} is in the way")
    rule_list, changes = root / "validate/rules.def", root / "CHANGELOG.md"
    lists = {
        rule_list: with_list_entry(rule_list.read_text(), wanted, name, rules),
        changes: with_change(changes.read_text(), wanted),
    }
    return new | lists


def parse(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("id", metavar="ID")
    parser.add_argument("alias", metavar="ALIAS")
    parser.add_argument("requirement", metavar="REQUIREMENT", choices=REQUIREMENTS, help=", ".join(REQUIREMENTS))
    parser.add_argument("title", metavar="TITLE")
    parser.add_argument("--root", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parent.parent)
    return parser.parse_args(arguments)


def main(arguments):
    wanted = parse(arguments)
    try:
        files = files_of(wanted.root, wanted)
    except Refused as refusal:
        print(f"new_rule.py: {refusal}", file=sys.stderr)
        return 2
    for path, text in files.items():
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        print(path.relative_to(wanted.root))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
