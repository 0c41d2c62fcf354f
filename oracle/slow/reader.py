"""Files: plain JSON, cases (`file.json#P`, `file.json#Q`), well-known text, `.poly`.

docs/formats.md describes the formats; GeoJSON is not read. Raises `InputError` with the file's
name. Cost: linear in the text, plus validity.py.
"""

from __future__ import annotations

from pathlib import Path

from .case import is_case, operand_of_case
from .exact import InputError
from .json_text import json_value
from .operand import Operand, operand_from_json
from .poly import of_poly
from .validity import refuse_invalid
from .wkt import of_wkt

MOST_BYTES = 32 << 20


def read_operand(name: str, validate: bool = True) -> Operand:
    """Read the operand in a file; `case.json#P` and `case.json#Q` name a case's operands. Without
    `validate`, rings may cross."""
    path, role = name, ""
    if name.endswith(("#P", "#Q")):
        path, role = name[:-2], name[-1]
    try:
        operand = of_text(text_of_file(path), Path(path).suffix, role)
        if validate:
            refuse_invalid(operand.polygons)
    except InputError as error:
        raise InputError(f"{path}: {error}") from error
    return operand


def text_of_file(path: str) -> str:
    try:
        with Path(path).open("rb") as stream:
            read = stream.read(MOST_BYTES + 1)
        text = read.decode("utf-8-sig")
    except (OSError, ValueError) as error:
        raise InputError(f"cannot be read: {error}") from error
    if len(read) > MOST_BYTES:
        raise InputError(f"the file is longer than {MOST_BYTES} bytes")
    if "\0" in text:
        raise InputError(f"letter {text.index(chr(0))} of the text is NUL")
    if not text.strip():
        raise InputError("the text is empty")
    return text


def of_text(text: str, ending: str, role: str) -> Operand:
    if ending == ".json":
        value = json_value(text)
        if is_case(value):
            return operand_of_case(value, role or "P")
    if role:
        raise InputError(f"#{role} names the operand of a case, and this is none")
    if ending == ".json":
        return operand_from_json(value)
    if ending == ".wkt":
        return of_wkt(text)
    if ending == ".poly":
        return of_poly(text)
    raise InputError("the name ends in none of .json, .wkt, .poly")
