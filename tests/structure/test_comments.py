#!/usr/bin/env python3
"""test_comments.py ROOT   comments of all C++ files: within the width of the code, and none begins like a sentence cut in
two ("Of the walls that ..."). Exit code 1 names each with its line."""

import re
import subprocess
import sys

WIDTH = 96  # ColumnLimit of .clang-format
CUT = re.compile(r"^\s*///?<? (Of|What|Those)\b(?!.*\?)")
MARK = re.compile(r"^\s*///? ")


def faults(path):
    before = ""
    with open(path, encoding="utf-8") as file:
        for number, line in enumerate(file, 1):
            line = line.rstrip("\n")
            if MARK.match(line):
                words = line.split("// ", 1)[1].split() if "// " in line else []
                if len(line) > WIDTH and len(words) > 1:
                    yield number, f"{len(line)} characters, at most {WIDTH}"
                if CUT.match(line) and not MARK.match(before):
                    yield number, "begins like half a sentence: " + line.strip()
            before = line


def main(root):
    names = subprocess.run(
        ["git", "-c", "safe.directory=*", "-C", root, "ls-files", "*.hpp", "*.cpp"],
        capture_output=True, text=True, check=True).stdout.split()
    found = [f"{name}:{number}: {text}" for name in names for number, text in faults(f"{root}/{name}")]
    print("\n".join(found) or f"{len(names)} files")
    return 1 if found or not names else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
