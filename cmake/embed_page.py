#!/usr/bin/env python3
"""Writes C++ that holds the style and the script of the HTML report, with their hashes.

usage: embed_page.py STYLE SCRIPT OUT.cpp
"""
import base64
import hashlib
import pathlib
import sys

CHUNK = 12_000  # bytes; compilers limit the length of one literal
DELIMITER = "rad_page"


def literal(data):
    text = data.decode()
    chunks = [text[i:i + CHUNK] for i in range(0, len(text), CHUNK)]
    return "\n".join(f'R"{DELIMITER}({chunk}){DELIMITER}"' for chunk in chunks)


def asset(name, path):
    data = pathlib.Path(path).read_bytes()
    lowered = data.lower()
    for ending in (b"</script", b"</style", b"<!--", f"){DELIMITER}\"".encode()):
        if ending in lowered:
            sys.exit(f"{path}: holds {ending.decode()}, which would end the element that it stands in")
    digest = base64.b64encode(hashlib.sha256(data).digest()).decode()
    return (f"const Asset& {name}() {{\n  static constexpr char text[] =\n{literal(data)};\n"
            f'  static constexpr Asset asset{{{{text, sizeof text - 1}}, "sha256-{digest}"}};\n  return asset;\n}}\n')


def main():
    style, script, out = sys.argv[1:]
    text = ('#include "report/html/assets.h"\n\nnamespace rad::report::html {\n\n'
            f'{asset("page_style", style)}\n{asset("page_script", script)}\n}}  // namespace rad::report::html\n')
    pathlib.Path(out).write_text(text)


if __name__ == "__main__":
    main()
