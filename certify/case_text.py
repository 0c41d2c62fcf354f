"""The case of a certificate, and the digest that binds both."""

from __future__ import annotations

import json
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.exact import digest, set_json
from minkref.version import version


def case_text(P: _core.PolygonSet, Q: _core.PolygonSet) -> str:
    """Returns a case for all scales (case-v1): both operands, with vertices in the order that
    certificates number."""
    head = f'"schema":"case-v1","id":"{case_digest(P, Q)[:12]}","dimension":2,"interval":{{}}'
    return f'{{{head},\n"P":{P.to_json()},\n"Q":{Q.to_json()}}}\n'


def case_digest(P: _core.PolygonSet, Q: _core.PolygonSet) -> str:
    """SHA-256 of both operands with numbers in lowest terms (docs/certificates.md)."""
    value = {"P": plain_polygons(P), "Q": plain_polygons(Q)}
    return digest(json.dumps(value, sort_keys=True, separators=(",", ":")))


def set_digest(P: _core.PolygonSet) -> str:
    """SHA-256 of the case of a set with a disc."""
    return digest(json.dumps({"P": plain_polygons(P)}, sort_keys=True, separators=(",", ":")))


def disc_head(
    form: str, P: _core.PolygonSet, square: Fraction, case: str, title: str, producer: str
) -> dict[str, Any]:
    """The members before the claims, of a certificate about P and discs of one squared radius."""
    return {
        "certificate": form,
        "title": title,
        "producer": producer or f"minkref {version()}",
        "case": {"path": case, "sha256": set_digest(P)},
        "square": str(square),
    }


def places(operand: _core.PolygonSet) -> list[tuple[Fraction, Fraction]]:
    """Returns the operand's vertices as a certificate numbers them."""
    return [(Fraction(x), Fraction(y)) for ring in _rings(operand) for x, y in ring]


def ring_numbers(operand: _core.PolygonSet) -> list[range]:
    """Returns each ring's vertex numbers."""
    numbers: list[range] = []
    first = 0
    for ring in _rings(operand):
        numbers.append(range(first, first + len(ring)))
        first += len(ring)
    return numbers


def _rings(operand: _core.PolygonSet) -> Iterator[list[list[str]]]:
    for polygon in plain_polygons(operand):
        yield from (polygon["outer"], *polygon["holes"])


def plain_polygons(operand: _core.PolygonSet) -> list[Any]:
    """Returns outer rings and holes by polygon, numbers in lowest terms."""
    polygons = json.loads(operand.to_json())["polygons"]
    text = set_json((polygon["outer"], polygon.get("holes", [])) for polygon in polygons)
    value: list[Any] = json.loads(text)["polygons"]
    return value
