#!/usr/bin/env python3
"""Code that a page quotes from a file stands there: a block that begins with ```cpp (or python) examples/FILE is a part of that file,
to the letter."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
BLOCK = re.compile(r"^```(?:cpp|python) (\S+)\n(.*?)^```$", re.DOTALL | re.MULTILINE)


def main() -> int:
    faults, blocks, quoted = [], 0, set()
    for page in sorted(ROOT.glob("*.md")) + sorted((ROOT / "docs").rglob("*.md")):
        for name, code in BLOCK.findall(page.read_text(encoding="utf-8")):
            blocks += 1
            quoted.add(ROOT / name)
            source = ROOT / name
            if not code.strip() or not source.exists() or code not in source.read_text(encoding="utf-8"):
                faults.append(f"{page.relative_to(ROOT)}: a block is not a part of {name}:\n{code}")
    for source in sorted((ROOT / "examples").rglob("*.cpp")):
        if source not in quoted:
            faults.append(f"{source.relative_to(ROOT)}: no page quotes it")
    print("\n".join(faults) if faults else f"{blocks} blocks are parts of their files")
    return 1 if faults or blocks == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
