#!/usr/bin/env python3
"""Checks that a program links none of the named shared libraries. usage: links_test.py PROGRAM LIBRARY..."""

import subprocess
import sys


def main() -> int:
    program, unwanted = sys.argv[1], sys.argv[2:]
    linked = subprocess.run(["ldd", program], check=True, capture_output=True, text=True).stdout
    names = [line.split()[0] for line in linked.splitlines() if line.strip()]
    if not any(name.startswith("libstdc++") for name in names):
        print(f"cannot tell what {program} links:\n{linked}")
        return 1
    found = [name for name in names if any(name.startswith(f"lib{each}.") for each in unwanted)]
    print(f"{program} links {', '.join(found)}" if found else f"{program} links none of {', '.join(unwanted)}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
