#!/usr/bin/env python3
"""Every page of docs is in its index, every command in the README, every effect and every room in the pages about
them, what the page about the C++ API names in its headers, what the page about the architecture names in
its files, and every relative link of a page leads to a file and a heading that exist."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
INDEX = ROOT / "docs/README.md"
README_LINES = 120  # more is not read
LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)\)")


def text_of(path) -> str:
    return (ROOT / path).read_text(encoding="utf-8")


def without_blocks(text: str) -> str:
    return re.sub(r"```.*?```", "", text, flags=re.DOTALL)


def anchors(page: pathlib.Path) -> set[str]:
    """The anchors that GitHub gives to the headings of a page."""
    headings = re.findall(r"^#+ +(.+)$", without_blocks(text_of(page)), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).strip().replace(" ", "-") for heading in headings}


def links_of(page: pathlib.Path) -> list[tuple[str, pathlib.Path, str]]:
    """Each relative link as it is written, the file it leads to, and the anchor there or an empty text."""
    found = []
    for target in LINK.findall(re.sub(r"`[^`\n]*`", "", without_blocks(text_of(page)))):
        if "://" not in target:
            path, _, anchor = target.partition("#")
            found.append((target, (page.parent / path).resolve() if path else page, anchor))
    return found


def faults_of_links(pages: list[pathlib.Path]) -> list[str]:
    found = []
    for page in pages:
        for target, there, anchor in links_of(page):
            if not there.exists():
                found.append(f"{page.relative_to(ROOT)}: {target}: does not exist")
            elif anchor and anchor not in anchors(there):
                found.append(f"{page.relative_to(ROOT)}: {target}: has no such heading")
    return found


def faults_of_index() -> list[str]:
    linked = {there for _, there, _ in links_of(INDEX)}
    return [f"{page.relative_to(ROOT)}: is missing from docs/README.md"
            for page in sorted((ROOT / "docs").rglob("*.md")) if page != INDEX and not linked & {page, page.parent}]


def faults_of_lists() -> list[str]:
    """What is a list in the code and a table in a page."""
    readme = text_of("README.md")
    commands = re.findall(r"^COMMAND\((\w+),", text_of("src/cli/commands.def"), re.M)
    effects = re.findall(r"^ +EFFECT\((\w+)\)", text_of("src/actuator/effects/standard_effects.cpp"), re.MULTILINE)
    found = [f"README.md: does not have the command {name}" for name in commands if f"| `{name}" not in readme]
    theory = text_of("docs/theory/effects.md")
    found += [f"docs/theory/effects.md: does not have the effect {name}" for name in effects
              if f"| `{name}` |" not in theory]
    rooms = re.findall(r"^set\(rooms ([\w ]+)\)", text_of("src/CMakeLists.txt"), re.MULTILINE)
    architecture = text_of("docs/architecture.md")
    found += [f"docs/architecture.md: does not have the room {name}" for name in " ".join(rooms).split()
              if f"| `{name}` |" not in architecture]
    if not (commands and effects and rooms):
        found.append("this test does not find the list of commands, effects or rooms any more")
    if len(readme.splitlines()) >= README_LINES:
        found.append(f"README.md: must have fewer than {README_LINES} lines")
    return found


def faults_of_api() -> list[str]:
    """Each row of docs/api.md: task, functions or types, the headers that have them, the target."""
    found, rows = [], 0
    for row in re.findall(r"^\|.*\.hpp.*\|$", text_of("docs/api.md"), re.MULTILINE):
        rows += 1
        _, names, headers, _ = (cell.strip() for cell in row.strip("|").split("|"))
        paths = [ROOT / "include/coilwright" / header for header in headers.split(", ")]
        if missing := [path for path in paths if not path.exists()]:
            found += [f"docs/api.md: {path.relative_to(ROOT)} does not exist" for path in missing]
            continue
        text = "".join(text_of(path) for path in paths)
        found += [f"docs/api.md: {name} is not in {headers}" for name in re.findall(r"`([\w:]+)`", names)
                  if not re.search(rf"\b{name.rpartition('::')[2]}\b", text)]
    return found if rows else ["docs/api.md: has no rows"]


def line_of(text: str) -> str:
    return " ".join(text.split())


def faults_of_quotes() -> list[str]:
    """What a README shows of a program's text is in the text that is kept of it, but for the spaces. A block that begins
    with a command has commands."""
    kept = {line_of(line) for path in (ROOT / "results/reference").rglob("*.txt") for line in path.open(encoding="utf-8")}
    found, quoted = [], 0
    for page in [ROOT / "README.md", *sorted((ROOT / "studies").glob("*/README.md"))]:
        for block in re.findall(r"^```\n(.*?)^```$", page.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL):
            lines = [line for line in block.splitlines() if line.strip()]
            if re.match(r"scripts/|python3 |apt-get ", lines[0]):
                continue
            quoted += len(lines)
            found += [f"{page.relative_to(ROOT)}: results/reference has no line {line_of(line)!r}"
                      for line in lines if line_of(line) not in kept]
    return found if quoted else ["no README shows what a program prints any more"]


def text_under(path: pathlib.Path) -> str:
    return "".join(text_of(file) for file in ([path] if path.is_file() else sorted(path.rglob("*.?pp"))))


def faults_of_decisions() -> list[str]:
    """Each row of docs/architecture.md, "Where decisions are made": question, functions or types, the files that have them."""
    table = text_of("docs/architecture.md").partition("\n## Where decisions are made\n")[2].partition("\n## ")[0]
    found, rows = [], 0
    for row in re.findall(r"^\|.* src/.*\|$", table, re.MULTILINE):
        rows += 1
        _, names, files = (cell.strip() for cell in row.strip("|").split("|"))
        paths = [ROOT / file for file in files.split(", ")]
        found += [f"docs/architecture.md: {path.relative_to(ROOT)} does not exist" for path in paths if not path.exists()]
        text = "".join(text_under(path) for path in paths if path.exists())
        found += [f"docs/architecture.md: {name} is not in {files}" for name in re.findall(r"`(\w+)`", names)
                  if not re.search(rf"\b{name}\b", text)]
    return found if rows else ["docs/architecture.md: has no table of decisions"]


def main() -> int:
    pages = sorted(page for folder in (ROOT.glob, (ROOT / "docs").rglob, (ROOT / "studies").rglob)
                   for page in folder("*.md"))
    faults = faults_of_links(pages) + faults_of_index() + faults_of_lists() + faults_of_api()
    faults += faults_of_decisions() + faults_of_quotes()
    print("\n".join(faults) if faults else f"{len(pages)} pages, all links lead somewhere")
    return 1 if faults or not pages else 0


if __name__ == "__main__":
    sys.exit(main())
