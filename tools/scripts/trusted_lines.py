#!/usr/bin/env python3
"""The table of docs/proved.md of what has to be believed, file by file with lines: prints it;
--write puts it into the page. Standard library only."""

from __future__ import annotations

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
ROOM = ROOT / "oracle" / "proved"
PAGE = ROOT / "docs" / "proved.md"
#: Files that are not believed: where they are wrong, the checker says no.
DOUBTED = {
    "pieces", "elaborate", "moving", "classes", "rings", "faces", "theorem", "point_theorem",
    "cells", "ways", "hits",
}  # fmt: skip
START, END = "<!-- trusted_lines.py --write -->\n", "<!-- end -->\n"


def rows() -> list[tuple[str, list[Path]]]:
    """Files, by what rests on them."""
    plane = ("Definitions", "Form", "Predicates", "Moving")
    definitions = {path.stem: path for path in (ROOM / "definitions").glob("*.v")}
    first = [definitions.pop(name) for name in plane]
    ways = [definitions.pop("Ways")]
    names = ("Legality", "Operations")
    answers = [*(definitions.pop(name) for name in names), ROOM / "verified" / "Statement.v"]
    driver = [path for path in (ROOM / "driver").iterdir() if path.stem not in DOUBTED]
    return [
        ("theorems in the plane", first),
        ("and of what is answered without a witness", answers),
        ("and of paths and traps", ways),
        ("and of convex polyhedra", sorted(definitions.values())),
        ("and `minkref-check-proved`", [ROOM / "claims" / "Extract.v", *sorted(driver)]),
    ]


def table() -> str:
    """The table as text, with sums."""
    lines = ["| believed for | files, with lines | lines |", "|---|---|---:|"]
    for name, files in rows():
        counts = [(path, path.read_text(encoding="utf-8").count("\n")) for path in files]
        told = ", ".join(f"`{path.name}` {count}" for path, count in counts)
        lines.append(f"| {name} | {told} | {sum(count for _, count in counts)} |")
    return "\n" + "\n".join(lines) + "\n\n"


def written(page: str) -> str:
    """The page with the table of now."""
    return re.sub(f"(?<={START}).*?(?={END})", lambda _: table(), page, count=1, flags=re.DOTALL)


if __name__ == "__main__":
    if sys.argv[1:] == ["--write"]:
        PAGE.write_text(written(PAGE.read_text(encoding="utf-8")), encoding="utf-8")
    else:
        print(table().strip())
