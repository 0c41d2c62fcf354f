"""Operands given as texts: on standard input, or on the command line itself."""

from __future__ import annotations

import json
import re
import sys

from minkref.errors import Refusal
from minkref.file_text import LONGEST, decoded

STANDARD_INPUT = "-"
_WKT = re.compile(
    r"\s*(SRID\s*=\s*\d+\s*;)?\s*((MULTI)?(POLYGON|POINT|LINESTRING)|GEOMETRYCOLLECTION)(ZM?|M)?\b",
    re.IGNORECASE,
)
MEND = "write WKT, GeoJSON, or the plain JSON of docs/formats.md"


def is_text(name: str) -> bool:
    """Tell whether a name means standard input, WKT or JSON; files and models with the name come
    first."""
    return name == STANDARD_INPUT or is_inline(name)


def is_inline(name: str) -> bool:
    return starts_wkt(name) or name.lstrip().startswith("{")


def text_and_form(name: str, inline: bool = False) -> tuple[str, str]:
    """Return the text and its format, which the beginning shows; with `inline`, `-` does not mean
    standard input. Refuses other formats, and texts longer than a file may be."""
    text = name if inline else text_of(name)
    if starts_wkt(text):
        return text, "wkt"
    if text.lstrip().startswith("{"):
        return text, "geojson" if _is_geojson(text) else "json"
    if re.match(r"\s*\d+\s", text):
        return text, "poly"
    where = repr(name) if inline else source_of(name)
    raise Refusal("this text is in no known format", where[:60], MEND, "unknown-format")


def text_of(name: str) -> str:
    """Read all of standard input if the name is `-`; else return the name itself."""
    if name != STANDARD_INPUT:
        return name
    text = decoded(_standard_input(), source_of(name))
    if not text.strip():
        mend = "pipe a set into it; it is one operand: name a file for the other"
        raise Refusal("there is nothing left to read", source_of(name), mend, "unknown-format")
    return text


def starts_wkt(text: str) -> bool:
    return _WKT.match(text) is not None


def _standard_input() -> bytes:
    """Read at most one byte more than a file may have. Refuses a closed stream, or an unreadable
    stream such as a folder or a stream opened only for writing."""
    why = "it is closed"
    if sys.stdin is not None:
        try:
            return sys.stdin.buffer.read(LONGEST + 1)
        except (OSError, ValueError) as error:
            why = getattr(error, "strerror", None) or str(error)
    what = f"standard input cannot be read: {why}"
    raise Refusal(what, "-", "pipe a set into it, or name a file", "cannot-read")


def source_of(name: str) -> str:
    """Name the operand in a message."""
    if name == STANDARD_INPUT:
        return "standard input"
    return name if len(name) <= 60 else f"{name[:57]}..."


def _is_geojson(text: str) -> bool:
    try:
        value = json.loads(text)
    except (ValueError, RecursionError):
        return False  # the reader of plain JSON tells the fault
    return isinstance(value, dict) and "type" in value
