"""Client of the swept solid: heights at which a sum's boundary changes, by CGAL in space."""

from __future__ import annotations

import os
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any

from minkref.fuzz.cgal.executables import SWEPT_SOLID, find_executable
from minkref.fuzz.cgal.server import OracleServer

MOST_PAIRS = 24
SECONDS = 60.0


@dataclass(frozen=True)
class SolidVertex:
    s: Fraction
    x: Fraction
    y: Fraction


@dataclass(frozen=True)
class SweptSolidAnswer:
    """`vertices`: the solid's vertices strictly between the two scales, sorted by scale; None
    without a result. `pairs` counts the triangle pairs united."""

    status: str
    reason: str | None = None
    vertices: tuple[SolidVertex, ...] | None = None
    pairs: int | None = None
    seconds: float | None = None


class SweptSolid(OracleServer):
    """{(s p + q, s)} as a Nef polyhedron (oracle/cgal/README.md): its vertices are the places and
    scales where the boundary of sP + Q changes. Limits for each call: pairs of triangles, `seconds`
    on the clock and `bytes` of address space."""

    def __init__(
        self,
        executable: str | os.PathLike[str] | None = None,
        most_pairs: int = MOST_PAIRS,
        seconds: float = SECONDS,
        bytes: int = 4 << 30,
    ) -> None:
        found = Path(executable) if executable else find_executable(SWEPT_SOLID)
        super().__init__(found, seconds, bytes)
        self.most_pairs = most_pairs

    def vertices(
        self, P: str | dict[str, Any], Q: str | dict[str, Any], low: str, high: str
    ) -> SweptSolidAnswer:
        """The solid's vertices between the scales `low` and `high` (`n` or `n/d`, 0 <= low < high).
        Exact. 0.01 to 0.1 s per pair of triangles. Every failure becomes an answer; OSError if no
        server starts."""
        value = self.ask(
            SWEPT_SOLID, {"P": P, "Q": Q}, most_pairs=self.most_pairs, **{"from": low, "to": high}
        )
        found = None
        if value["status"] == "result":
            found = tuple(
                SolidVertex(Fraction(v["s"]), Fraction(v["at"][0]), Fraction(v["at"][1]))
                for v in value["vertices"]
            )
        return SweptSolidAnswer(
            value["status"], value.get("reason"), found, value.get("pairs"), value.get("seconds")
        )
