"""Surfaces as texts of programs: vertices and triangles."""

from __future__ import annotations

import json
from collections.abc import Callable
from fractions import Fraction

from minkref.fuzz.adapters.surfaces import triangles_of

PER_LINE = 6


def surfaces(
    operands: tuple[str, str], number: Callable[[str], str], brackets: str = "[]"
) -> dict[str, str]:
    """The vertices and triangles of P and Q (JSON) as lists in the brackets: P_VERTICES, ..."""
    fields = {}
    for name, text in zip("PQ", operands, strict=True):
        value = json.loads(text)
        vertices = [[number(n) for n in vertex] for vertex in value["vertices"]]
        triangles = triangles_of(value["vertices"], value["faces"])
        fields[f"{name}_VERTICES"] = _rows(vertices, brackets)
        fields[f"{name}_TRIANGLES"] = _rows([[str(k) for k in t] for t in triangles], brackets)
    return fields


def double(number: str) -> str:
    return repr(float(Fraction(number)))


def quoted(number: str) -> str:
    return f'"{number}"'


def _rows(rows: list[list[str]], brackets: str) -> str:
    left, right = brackets[0], brackets[1]
    texts = [f"{left}{', '.join(row)}{right}" for row in rows]
    lines = [", ".join(texts[k : k + PER_LINE]) for k in range(0, len(texts), PER_LINE)]
    return f"{left}" + ",\n    ".join(lines) + f"{right}"
