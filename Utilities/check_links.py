# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkOIT developers
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that every relative link of the Markdown pages leads to a file, and to a heading in it."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LINK = re.compile(r"\]\((?!https?:|mailto:)([^)#\s]*)(?:#([^)\s]*))?\)")


def anchors(page):
    """The names that headings get: lower case, blanks as dashes, other signs left out."""
    for heading in re.findall(r"^#+\s+(.*)$", page.read_text(encoding="utf-8"), re.MULTILINE):
        yield re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


def main():
    broken = 0
    for page in sorted([*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md")]):
        for name, anchor in LINK.findall(page.read_text(encoding="utf-8")):
            target = page.parent / name if name else page
            if not target.exists():
                problem = "no such file"
            elif anchor and target.suffix == ".md" and anchor not in anchors(target):
                problem = "no such heading"
            else:
                continue
            print(f"{page.relative_to(ROOT)}: {name}#{anchor}: {problem}", file=sys.stderr)
            broken += 1
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
