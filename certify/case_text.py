"""The case of a certificate, and the digest that binds them."""

from __future__ import annotations

import json
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.exact import digest


def case_text(P: _core.PolygonSet, Q: _core.PolygonSet) -> str:
    """Both operands in plain JSON, their vertices in the order that certificates number."""
    return f'{{"P":{P.to_json()},\n"Q":{Q.to_json()}}}\n'


def case_digest(P: _core.PolygonSet, Q: _core.PolygonSet) -> str:
    """SHA-256 of both operands with numbers in lowest terms (docs/certificates.md)."""
    value = {"P": _plain(json.loads(P.to_json())), "Q": _plain(json.loads(Q.to_json()))}
    return digest(json.dumps(value, sort_keys=True, separators=(",", ":")))


def _plain(value: dict[str, Any]) -> list[dict[str, Any]]:
    return [
        {
            "holes": [_ring(ring) for ring in polygon.get("holes", [])],
            "outer": _ring(polygon["outer"]),
        }
        for polygon in value["polygons"]
    ]


def _ring(ring: list[list[Any]]) -> list[list[str]]:
    return [[str(Fraction(x)), str(Fraction(y))] for x, y in ring]
