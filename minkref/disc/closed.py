"""Closings and openings by a disc (docs/erosion.md)."""

from __future__ import annotations

import json
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.argument_types import expect_sets, whole
from minkref.disc.disc import Disc
from minkref.disc.disc_index import Number, square_of
from minkref.disc.polygons import inset_near, sum_near
from minkref.errors import Refusal
from minkref.exact import digest

Step = tuple[str, float, float, float, float, float, float]
Place = tuple[str, str]


@dataclass(frozen=True)
class DiscClosing:
    """A closing or an opening by a disc. `area` equals a double or lies between two neighbouring
    doubles. `rings`: lines and arcs in nearest doubles, (kind, x and y of the start, of the end, of
    an arc's centre); arcs run counter-clockwise, a closing lies on the right, an opening on the
    left. `arcs`: each arc exactly, as expressions: its centre, and two points on its circle that
    bound the arc, or the longer arc of which it is a part. `canonical_json`: the set of all centres
    of discs that tells the whole set, in rational numbers; None for an opening through places at
    which the disc just fits."""

    components: int
    holes: int
    area: tuple[float, float]
    rings: list[list[Step]]
    arcs: list[tuple[Place, Place, Place]]
    canonical_json: str | None
    seconds: float

    @property
    def digest(self) -> str | None:
        """The SHA-256 of the canonical JSON."""
        return None if self.canonical_json is None else digest(self.canonical_json)


def closed_by_disc(P: _core.PolygonSet, square: str, name: str, threads: int) -> DiscClosing:
    """Close P by a disc. Where the disc just fits outside of P, the sum covers its centre, and the
    closing what it touches."""
    _refuse_thin(P, name)
    around = _core.offset(P, square, threads)
    return _found(P, square, False, threads, "closing", around.canonical_json())


def opened_by_disc(P: _core.PolygonSet, square: str, name: str, threads: int) -> DiscClosing:
    """Open P by a disc: all discs within P together."""
    _refuse_thin(P, name)
    within = _core.inset(P, square, threads)
    is_told = not within.tight_passages(threads)
    form = within.canonical_json() if is_told else None
    return _found(P, square, True, threads, "opening", form)


def closing_by_disc(
    P: _core.PolygonSet,
    radius: Number | None = None,
    squared_radius: Number | None = None,
    threads: int = 1,
) -> DiscClosing:
    """Close P by a disc about the origin, given by `radius` > 0 or by the radius's square: the sum
    of P and the disc, eroded by the disc. P with all that no disc of a larger radius outside of P
    reaches; discs that just fit reach nothing. Exact: finds the diagram of all radii. Refuses sets
    without area. Validates P. Raises BadInput, LimitExceeded. docs/erosion.md."""
    square = _square(P, radius, squared_radius, "closing_by_disc")
    return closed_by_disc(P, square, "P", max(1, whole("threads", threads)))


def opening_by_disc(
    P: _core.PolygonSet,
    radius: Number | None = None,
    squared_radius: Number | None = None,
    threads: int = 1,
) -> DiscClosing:
    """Open P by a disc: all discs of the radius within P together. As closing_by_disc; discs that
    just fit count. docs/erosion.md."""
    square = _square(P, radius, squared_radius, "opening_by_disc")
    return opened_by_disc(P, square, "P", max(1, whole("threads", threads)))


def _square(
    P: _core.PolygonSet, radius: Number | None, squared_radius: Number | None, function: str
) -> str:
    expect_sets(P=P)
    P.validate("P")
    return square_of(radius, squared_radius, function)


def _refuse_thin(P: _core.PolygonSet, name: str) -> None:
    if not P.is_region and not P.is_empty:
        what = "it has no area; openings and closings by a disc are of regions"
        raise Refusal(what, name, "give a set of polygons", "degenerate-operands")


def _found(
    P: _core.PolygonSet, square: str, inward: bool, threads: int, kind: str, form: str | None
) -> DiscClosing:
    text = None if form is None else f'{{"{kind}":{form}}}'
    if P.is_empty:
        return DiscClosing(0, 0, (0.0, 0.0), [], [], text, 0.0)
    found = _core.closed_by_disc(P, square, inward, threads)
    rings, arcs = found.rings(), found.exact_arcs()
    counts = found.components, found.holes
    return DiscClosing(*counts, found.area(), rings, arcs, text, found.seconds)


def closing_near(
    P: _core.PolygonSet, disc: Disc, within: Fraction, outside: bool
) -> _core.PolygonSet:
    """Make a polygon set inside P's closing by a disc, or around it. Half of `within` for each
    step: the sum, and its erosion."""
    return inset_near(sum_near(P, disc, within / 2, outside), disc, within / 2, outside)


def opening_near(
    P: _core.PolygonSet, disc: Disc, within: Fraction, outside: bool
) -> _core.PolygonSet:
    """The same for the opening: the erosion, and its sum."""
    left = inset_near(P, disc, within / 2, outside)
    return left if left.is_empty else sum_near(left, disc, within / 2, outside)


def steps_of(found: DiscClosing) -> list[list[dict[str, Any]]]:
    """List each ring's steps for a document."""
    return [
        [
            {
                "kind": kind,
                "from": [x0, y0],
                "to": [x1, y1],
                "centre": [x, y] if kind == "arc" else None,
            }
            for kind, x0, y0, x1, y1, x, y in ring
        ]
        for ring in found.rings
    ]


def form_of(found: DiscClosing) -> Any:
    """Read the canonical form."""
    return None if found.canonical_json is None else json.loads(found.canonical_json)
