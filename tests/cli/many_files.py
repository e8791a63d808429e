#!/usr/bin/env python3
"""Two thousand small files: the cache and the shards give the bytes of one plain run.

usage: many_files.py RADLINT SMALL_MODELS
"""
import os
import pathlib
import subprocess
import sys
import tempfile

COUNT = 2000


def main():
    radlint, small_models = (str(pathlib.Path(path).resolve()) for path in sys.argv[1:3])
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        subprocess.run([sys.executable, small_models, "models", str(COUNT)], check=True)

        def run(*args, expected=1):
            done = subprocess.run([radlint, *args], capture_output=True, check=False)
            assert done.returncode == expected, (args, done.returncode, done.stderr[-500:])
            return done.stdout

        plain = run("models", "--no-cache", "--format", "json")
        assert plain.count(b'"path":') == COUNT, "a report of all files"
        assert run("models", "--cache", "kept", "--format", "json") == plain, "into an empty cache"
        assert run("models", "--cache", "kept", "--format", "json") == plain, "out of a full cache"
        changed = pathlib.Path("models/00/00000.obj")
        changed.write_text(changed.read_text().replace("o lamp", "o light"))
        newer = run("models", "--no-cache", "--format", "json")
        assert newer != plain and run("models", "--cache", "kept", "--format", "json") == newer, "one file changed"
        for part in range(1, 5):
            run("models", "--cache", "kept", "--shard", f"{part}/4", "-q", "--report", f"json=part{part}.json")
        parts = [f"part{part}.json" for part in (2, 4, 1, 3)]
        assert run("merge", *parts, "--format", "json") == newer, "four shards"
        pathlib.Path("models/radlint.toml").write_text('[rules.RL110]\nseverity = "note"\n')
        quiet = run("models", "--cache", "kept", "--format", "json", expected=0)
        assert quiet == run("models", "--no-cache", "--format", "json", expected=0), "the configuration is in the key"
    print(f"{COUNT} files: cache, shards and configuration give the bytes of plain runs")


if __name__ == "__main__":
    main()
