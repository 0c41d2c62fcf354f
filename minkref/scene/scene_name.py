"""Tells a scene from an operand by its name alone."""

from __future__ import annotations

import json
from pathlib import Path

from minkref.plane.operand_text import STANDARD_INPUT, is_inline, starts_wkt

MEMBERS = {"schema", "robot", "copies"}
OF_OPERANDS = {"type", "polygons", "P"}  # of GeoJSON, of plain JSON, of cases; no scene has any
LARGEST = 1 << 26  # bytes of a file that is read to tell; a larger one counts as a scene


def names_scene(name: str) -> bool:
    """Tell whether an operand that stands alone means a scene: standard input, JSON as text, or a
    file that ends in .json; not if it is JSON without a member of a scene, or with one of an
    operand."""
    if name == STANDARD_INPUT:
        return True
    if is_inline(name):
        return not starts_wkt(name) and _may_be_scene(name)
    path = Path(name)
    if path.suffix.lower() != ".json":
        return False
    try:
        return path.stat().st_size > LARGEST or _may_be_scene(path.read_text(encoding="utf-8-sig"))
    except (OSError, ValueError):
        return True  # the reader of scenes says why


def _may_be_scene(text: str) -> bool:
    try:
        value = json.loads(text)
    except (ValueError, RecursionError):
        return True
    if not isinstance(value, dict):
        return True
    return bool(MEMBERS & value.keys()) and not OF_OPERANDS & value.keys()
