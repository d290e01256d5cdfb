#!/usr/bin/env python3
"""Builds targets of preset release and says how far it is and about how long it still takes: at a terminal in one line
that is written over, elsewhere in a line a minute; silent where nothing is to be built. usage: build.py TARGET...

What is to be compiled is ninja's own list, each source weighed by its bytes; what the compiler says is in build.log."""

import pathlib
import re
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
BUILD = ROOT / "build/release"
STEP = re.compile(r"\[\d+/\d+\] (?:Building \w+ object (\S+)\.o)?")
HEADERS = 60_000  # bytes of source whose compilation takes as long as what every step has to include


def weight(made: str | None) -> int:
    """Of a step that compiles the source of this object file; of another step next to nothing."""
    if made is None:
        return 1
    joined = BUILD / made  # in the build folder: a source that includes others
    source = ROOT / re.sub(r"/?CMakeFiles/[^/]*\.dir", "", made)
    if joined.is_file():
        parts = re.findall(r'^#include "(.*)"', joined.read_text(encoding="utf-8"), re.MULTILINE)
        return HEADERS + sum(pathlib.Path(part).stat().st_size for part in parts if pathlib.Path(part).is_file())
    return HEADERS + (source.stat().st_size if source.is_file() else 0)


def steps(lines):
    for line in lines:
        if found := STEP.match(line):
            yield weight(found[1])


def duration(seconds: float) -> str:
    return f"{seconds:.0f} s" if seconds < 90 else f"{seconds / 60:.0f} min"


def main(targets: list[str]) -> int:
    ninja = ["ninja", "-C", str(BUILD), *targets]
    needed = subprocess.run(["ninja", "-C", str(BUILD), "-t", "inputs", *targets], capture_output=True, text=True, check=False)
    planned = sum(weight(each[:-2]) for each in needed.stdout.split()
                  if each.endswith(".o") and not (BUILD / each).exists())
    terminal = sys.stderr.isatty()
    begun = told = time.monotonic()
    done, shown = 0, False
    with open(ROOT / "build.log", "a", encoding="utf-8") as log:
        with subprocess.Popen(ninja, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) as run:
            for line in run.stdout:
                log.write(line)
                done += sum(steps([line]))
                now = time.monotonic()
                if planned < HEADERS or not (terminal or now - told >= 60):
                    continue
                share = min(done / planned, 0.99)
                left = f", about {duration((now - begun) * (1 - share) / share)} more" if share > 0.05 else ""
                text = f"coilwright: {100 * share:.0f} % compiled after {duration(now - begun)}{left}"
                print(f"\r{text}\033[K" if terminal else text, end="" if terminal else "\n", file=sys.stderr, flush=True)
                told, shown = now, terminal
    if shown:
        print("\r\033[K", end="", file=sys.stderr, flush=True)
    return run.returncode


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
