"""`python -m oracle.features`: reads a WKT polygon or multipolygon from standard input, writes the
judge's document as JSON."""

from __future__ import annotations

import json
import re
import sys

from .form import canonical_json
from .judge import Judge


def polygons_of(text: str) -> list[list[list[tuple[str, str]]]]:
    """Rings of WKT, without their closing points."""
    body = text.strip()
    if body.upper().startswith("POLYGON"):
        body = f"({body[len('POLYGON') :]})"
    found: list[list[list[tuple[str, str]]]] = []
    depth = 0
    for token in re.findall(r"\(|\)|[^(),]+", body[body.index("(") :]):
        if token == "(":
            depth += 1
            if depth == 2:
                found.append([])
            elif depth == 3:
                found[-1].append([])
        elif token == ")":
            depth -= 1
            if depth == 2:
                found[-1][-1].pop()
        elif token.strip():
            x, y = token.split()
            found[-1][-1].append((x, y))
    return found


if __name__ == "__main__":
    judge = Judge(polygons_of(sys.stdin.read()))
    tree = json.loads(canonical_json(judge))
    print(json.dumps({**judge.document(), "tree": tree}, indent=1))
