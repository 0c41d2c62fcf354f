"""The exact sum of polyhedra of any shape, by the reference, with limits on time and size."""

from __future__ import annotations

import json
import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property
from types import FrameType

from minkref import _core
from minkref.errors import message_of
from minkref.fuzz.geometry.polyhedron import Face, Polyhedron
from minkref.fuzz.geometry.space import Point, Scale, Whole
from minkref.fuzz.space.convex_sum import scaling_of
from minkref.fuzz.space.membership import Surface
from minkref.fuzz.space.sites import sites
from minkref.fuzz.space.trapezoids import trapezoids
from minkref.oracle.slow.space.exposed import (
    Exposed,
    exposed_from_json,
    is_mirrored,
    lifted,
    rings_of,
)

EDGES, DEFINITION = "edges", "definition"
ROUTES = {EDGES: _core.edge_sum_in_space, DEFINITION: _core.definition_sum_in_space}
MOST_TRIANGLES = 200_000  # triangles in P times triangles in Q
SECONDS = 20.0
REFUSALS = (_core.BadInput, RuntimeError, MemoryError)


@dataclass(frozen=True)
class ExactSum:
    """A polyhedron with trapezoids as faces, their insides disjoint."""

    polyhedron: Polyhedron

    @cached_property
    def surface(self) -> Surface:
        return Surface(self.polyhedron)

    @cached_property
    def sites(self) -> list[tuple[Whole, Point]]:
        return list(sites(self.polyhedron))


def exact_sum(P: Polyhedron, Q: Polyhedron, scale: Scale, route: str) -> ExactSum | str:
    """Returns sP + Q, or a sentence why none exists. Operands that cross themselves have none; one
    may be a point or a segment."""
    count = max(1, len(P.triangles)) * max(1, len(Q.triangles))
    if count > MOST_TRIANGLES:
        return f"{count:,} pairs of triangles, more than {MOST_TRIANGLES:,}"
    try:
        with _limited(SECONDS):
            return ExactSum(polyhedron_of_planes(exposed_sum(P, Q, scale, route)))
    except OutOfTime:
        return f"it takes more than {SECONDS:g} seconds"
    except REFUSALS as error:
        return message_of(error)


def exposed_sum(P: Polyhedron, Q: Polyhedron, scale: Scale, route: str) -> Exposed:
    """Sums by a route of the reference. Raises its exceptions: _core.BadInput for invalid operands,
    _core.LimitExceeded."""
    operands = [core_polyhedron(solid) for solid in (P, Q)]
    for solid, operand in zip((P, Q), operands, strict=True):
        if not solid.is_thin:
            operand.validate()
    found = ROUTES[route](operands[0], operands[1], scaling_of(scale))
    return exposed_from_json(json.loads(found.canonical_json()))


def core_polyhedron(solid: Polyhedron) -> _core.Polyhedron:
    points = [(str(x), str(y), str(z)) for x, y, z in solid.vertices]
    return _core.Polyhedron(points, [list(face) for face in solid.faces])


def polyhedron_of_planes(exposed: Exposed) -> Polyhedron:
    """Converts a set given by canonical regions to a surface of trapezoids."""
    names: dict[Point, int] = {}
    faces: list[Face] = []
    for plane, polygons in exposed.planes.items():
        for polygon in polygons:
            for part in trapezoids(rings_of([polygon])):
                ring = [lifted(corner, plane) for corner in part]
                if is_mirrored(plane[0]):
                    ring.reverse()
                faces.append(tuple(names.setdefault(corner, len(names)) for corner in ring))
    return Polyhedron(tuple(names), tuple(faces))


class OutOfTime(Exception):
    """The time for a sum is over."""


@contextmanager
def _limited(seconds: float) -> Iterator[None]:
    """Raises OutOfTime after so many seconds, in the main thread, where signals arrive; elsewhere
    only the number of triangles sets a limit. Leaves a running timer alone."""
    if threading.current_thread() is not threading.main_thread() or any(
        signal.getitimer(signal.ITIMER_REAL)
    ):
        yield
        return

    def end(number: int, frame: FrameType | None) -> None:
        raise OutOfTime

    before = signal.signal(signal.SIGALRM, end)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
