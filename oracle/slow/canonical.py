"""Canonical JSON and its digest (docs/definitions.md, "Canonical form")."""

from __future__ import annotations

import hashlib
import json

from .exact import Point, text_of
from .operand import Polygon


def ring_json(ring: list[Point]) -> list[list[str]]:
    return [[text_of(x), text_of(y)] for x, y in ring]


def document(polygons: list[Polygon]) -> dict[str, object]:
    """Build the hashed object from polygons in canonical form."""
    return {
        "polygons": [
            {"holes": [ring_json(hole) for hole in part.holes], "outer": ring_json(part.outer)}
            for part in polygons
        ]
    }


def digest(polygons: list[Polygon]) -> str:
    """Return the SHA-256 of the canonical JSON in lower-case hexadecimal."""
    text = json.dumps(document(polygons), separators=(",", ":"))
    return hashlib.sha256(text.encode()).hexdigest()
