#!/usr/bin/env python3
"""Holds man pages and completions of a program against its --help: every option in each, and no other.

usage: documented_options.py PROGRAM MAN_SOURCE
"""
import pathlib
import re
import shutil
import subprocess
import sys

OPTION = re.compile(r"(?<![\w-])(--?[a-zA-Z][\w-]*)")


def run(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def help_of(program, *subcommand):
    return run(program, *subcommand, "--help")


def subcommands(text):
    """Names in the section that CLI11 heads with Subcommands:, empty where there is none."""
    match = re.search(r"^Subcommands:\n((?:  .*\n?)+)", text, re.M)
    return re.findall(r"^  (\S+)", match[1], re.M) if match else []


def options_of_help(text):
    """Options stand at the beginning of a line, two blanks in: '  -j,--jobs N'."""
    found = set()
    for line in re.findall(r"^  (-\S+)", text, re.M):
        found |= set(OPTION.findall(line))
    return found


def options_of_man(source):
    """Options stand in bold at the beginning of a line: '*-j*, *--jobs* _N_'."""
    found = set()
    for line in source.splitlines():
        if line.startswith("*-"):
            found |= set(re.findall(r"\*(--?[a-zA-Z][\w-]*)\*", line))
    return found


def options_of_fish(script):
    return {"--" + name for name in re.findall(r" -l (\S+)", script)} | {
        "-" + name for name in re.findall(r" -s (\S+)", script)}


def complaints(where, found, wanted):
    for name in sorted(wanted - found):
        yield f"{where}: {name} is missing"
    for name in sorted(found - wanted):
        yield f"{where}: {name} is no option"


def bash_reply(script, *words):
    """What bash offers for the last word."""
    quoted = " ".join(f"'{word}'" for word in words)
    test = (f"compopt() {{ :; }}; {script}\nCOMP_WORDS=({quoted}); COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1)); "
            f"_{words[0]}; printf '%s\\n' \"${{COMPREPLY[@]}}\"")
    return set(run("bash", "-c", test).split())


def main():
    program, man_path = sys.argv[1:]
    name = pathlib.Path(program).name
    text = help_of(program)
    commands = subcommands(text)
    wanted = options_of_help(text)
    everywhere = set(wanted).union(*(options_of_help(help_of(program, command)) for command in commands))
    source = pathlib.Path(man_path).read_text()
    scripts = {shell: run(program, "--completion", shell) for shell in ("bash", "zsh", "fish")}
    found = list(complaints("man page", options_of_man(source), everywhere))
    found += complaints("fish", options_of_fish(scripts["fish"]), everywhere)
    found += complaints("bash", bash_reply(scripts["bash"], name, "-"), wanted)
    found += [f"man page: no word on the subcommand {command}" for command in commands
              if not re.search(rf"^\*{name} {command}\*", source, re.M)]
    for option in sorted(everywhere):
        if not re.search(rf"^\s*'\*{option}[=+\[]", scripts["zsh"], re.M):
            found.append(f"zsh: {option} is missing")
    if bash_reply(scripts["bash"], name, "--completion", "=", "z") != {"zsh"}:
        found.append("bash: --completion=z is not completed to zsh")
    for shell in ("zsh", "fish"):
        if shutil.which(shell):
            subprocess.run([shell, "-n"], input=scripts[shell], text=True, check=True)
    if len(wanted) < 5:
        found.append("--help shows next to no options: its form has changed")
    print("\n".join(found) if found else f"{len(everywhere)} options, each documented and completed")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
