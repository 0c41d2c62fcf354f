"""Sums, and sets that are combined, by the program that `make proofs` extracts, read back as sets:
`--route proved` and `--proved`."""

from __future__ import annotations

import json
import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

from minkref import _core, proved_program
from minkref.errors import Refusal
from minkref.exact import digest
from minkref.plane.operand import Operand
from minkref.plane.scaling import PlaneScale, document_of

ROUTE = "proved"


@dataclass(frozen=True)
class ProvedSum:
    """As `_core.Sum`, as far as documents need it."""

    region: _core.PolygonSet
    components: int
    holes: int
    seconds: float
    statistics: dict[str, Any] = field(default_factory=dict)


def proved_sum(P: Operand, Q: Operand, scale: PlaneScale) -> ProvedSum:
    """An answer is proved to be the sum in canonical form (docs/proved.md). Raises Refusal of two
    points or segments, and where the program is absent; MemoryError, and RuntimeError where it
    breaks down, or answers otherwise than it was read back."""
    if not any(each.set.is_region or each.set.is_empty for each in (P, Q)):
        what = "no theorem speaks of the sum of two points or segments"
        raise Refusal(what, f"--route {ROUTE}", "take another route", "not-proved")
    began = time.perf_counter()
    told = proved_program.whole_sum(P.set.to_json(), Q.set.to_json(), document_of(scale))
    seconds = time.perf_counter() - began
    return ProvedSum(_read_back(told), told["components"], told["holes"], seconds)


def proved_combination(
    operation: str, sets: Sequence[_core.PolygonSet]
) -> tuple[_core.PolygonSet, int, int]:
    """As `_core.combined`, proved to be that set in canonical form. Raises as `proved_sum`."""
    told = proved_program.combination(operation, [each.to_json() for each in sets])
    return _read_back(told), told["components"], told["holes"]


def _read_back(told: dict[str, Any]) -> _core.PolygonSet:
    text = json.dumps({"polygons": told["polygons"]})
    region = _core.read_text(text, "json", proved_program.PROGRAM)
    if digest(region.canonical_json()) != told["digest"]:
        raise RuntimeError(f"{proved_program.PROGRAM}: the set is not in canonical form")
    return region
