"""Case files in space: two polyhedra, and factors for each axis."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.errors import Refusal, cut, refusing
from minkref.exact import read_scale
from minkref.file_text import text_of_file
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.space.case import SpaceCase
from minkref.fuzz.space.convex_sum import polyhedron_of

DIMENSION = 3
MEND = 'write "scales": [["1", "2", "3/5"], ...] in a case of dimension 3'


def is_in_space(value: Any) -> bool:
    """Whether a JSON value looks like a case in space."""
    return (
        isinstance(value, dict)
        and value.get("schema") == "case-v1"
        and value.get("dimension") == DIMENSION
    )


def scalings_in(value: dict[str, Any], where: str) -> list[str]:
    """Returns the scalings at which the case asks, each `SX,SY,SZ` in lowest terms, or `S` for
    equal factors. Refuses anything but a list of them."""
    scales = value.get("scales")
    if not isinstance(scales, list) or not scales:
        raise Refusal("a case in space has no scales", where, MEND, "missing-member")
    return [_scaling(scale, where) for scale in scales]


def _scaling(value: Any, where: str) -> str:
    if (
        not isinstance(value, list)
        or len(value) != DIMENSION
        or not all(type(factor) in (str, int) for factor in value)
    ):
        what = f"this is no scaling of three factors: {cut(json.dumps(value))}"
        raise Refusal(what, where, MEND, "wrong-type")
    factors = [read_scale(str(factor), f"{where} scales:") for factor in value]
    return factors[0] if len(set(factors)) == 1 else ",".join(factors)


def read_space_case(name: CaseName, path: Path, scale: str) -> SpaceCase:
    """Reads the case at one scaling. Refuses an operand that is missing, or no polyhedron."""
    value = json.loads(text_of_file(path, str(path), MEND), parse_float=str)
    operands = []
    for part in "PQ":
        where = f"{path}#{part}"
        if not isinstance(value.get(part), dict):
            mend = 'write {"vertices": [[x, y, z], ...], "faces": [[i, j, k, ...], ...]}'
            raise Refusal("the operand is missing", where, mend, "missing-member")
        operands.append(_read(json.dumps(value[part]), where))
    return SpaceCase.of(name, operands, scale, f"{path}@{cut(scale)}")


def _read(text: str, where: str) -> Any:
    content = text.encode("utf-8")
    surface, _ = refusing(where, lambda: _core.read_mesh_text(content, "json", where))
    return polyhedron_of(surface).document()
