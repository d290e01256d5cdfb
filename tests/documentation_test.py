#!/usr/bin/env python3
"""Every page of docs is in its index, every command in the README, and every relative link of a page leads to a file and a
heading that exist."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
INDEX = ROOT / "docs/README.md"
LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)\)")


def without_code(text: str) -> str:
    return re.sub(r"```.*?```|`[^`\n]*`", "", text, flags=re.DOTALL)


def anchors(page: pathlib.Path) -> set[str]:
    """The anchors that GitHub gives to the headings of a page."""
    found = set()
    for heading in re.findall(r"^#+ +(.+)$", re.sub(r"```.*?```", "", page.read_text(encoding="utf-8"), flags=re.DOTALL),
                              re.MULTILINE):
        found.add(re.sub(r"[^\w\- ]", "", heading.lower()).strip().replace(" ", "-"))
    return found


def main() -> int:
    pages = sorted(ROOT.glob("*.md")) + sorted((ROOT / "docs").rglob("*.md")) + sorted((ROOT / "studies").rglob("*.md"))
    faults, linked = [], set()
    for page in pages:
        for target in LINK.findall(without_code(page.read_text(encoding="utf-8"))):
            if "://" in target:
                continue
            path, _, anchor = target.partition("#")
            there = (page.parent / path).resolve() if path else page
            where = f"{page.relative_to(ROOT)}: {target}"
            if not there.exists():
                faults.append(f"{where}: does not exist")
            elif anchor and anchor not in anchors(there):
                faults.append(f"{where}: has no such heading")
            if page == INDEX:
                linked.add(there)
    for page in sorted((ROOT / "docs").rglob("*.md")):
        if page != INDEX and not linked & {page, page.parent}:
            faults.append(f"{page.relative_to(ROOT)}: is missing from docs/README.md")
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    for command in re.findall(r"add_(\w+)_command", (ROOT / "src/cli/main.cpp").read_text(encoding="utf-8")):
        if f"| `{command}" not in readme:
            faults.append(f"README.md: does not have the command {command}")
    print("\n".join(faults) if faults else f"{len(pages)} pages, all links lead somewhere")
    return 1 if faults or not pages else 0


if __name__ == "__main__":
    sys.exit(main())
