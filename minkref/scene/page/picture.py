"""Data for the scripts of a scene's page."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.errors import Refusal
from minkref.plane.page.boundary import Progress, Window, ring_data, rings_of, states_of
from minkref.plane.page.linear import double
from minkref.plane.page.passages import passages_at
from minkref.scene.copies_text import CopyRow

MOST_COPIES = 10_000
ROOM = 2  # factor from a shape's smallest and greatest scale to the window's ends


def picture(
    robot: _core.PolygonSet,
    shapes: Mapping[str, _core.PolygonSet],
    copies: Sequence[CopyRow],
    threads: int,
    progress: Progress,
) -> dict[str, Any]:
    """Return the fields of the page's data (docs/command-line.md, "minkref view of a scene").
    Scales, places and sets are exact texts; rings are doubles. Equal shapes share one index of
    their sums with the robot turned by 180 degrees. Refuses numbers beyond doubles, and more than
    MOST_COPIES copies."""
    if len(copies) > MOST_COPIES:
        what = f"the scene has {len(copies):,} copies, and a page holds {MOST_COPIES:,}"
        raise Refusal(what, "view", "see `minkref scene`, or leave copies out", "limit")
    _refuse_beyond_doubles(copies)
    keys = [_key(shape) for shape in shapes.values()]
    scales: dict[str, list[Fraction]] = {}
    for copy in copies:
        scales.setdefault(keys[copy.shape], []).append(Fraction(copy.scale))
    numbers = {key: number for number, key in enumerate(scales)}
    turned = robot.scaled("-1")
    sets = dict(zip(keys, shapes.values(), strict=True))
    return {
        "robot": _set(robot),
        "shapes": [
            {"name": name, "sum": numbers.get(key), **_set(shape)}
            for key, (name, shape) in zip(keys, shapes.items(), strict=True)
        ],
        "sums": [_sum(sets[key], turned, used, threads, progress) for key, used in scales.items()],
        "copies": [list(copy) for copy in copies],
    }


def window_of(scales: Sequence[Fraction]) -> Window:
    """Widen a shape's scales to the window that its copies may use on the page."""
    return Window(str(min(scales) / ROOM), str(max(scales) * ROOM))


def _sum(
    P: _core.PolygonSet,
    Q: _core.PolygonSet,
    used: Sequence[Fraction],
    threads: int,
    progress: Progress,
) -> dict[str, Any]:
    window = window_of(used)
    sums = _core.ScaleIndex(P, Q, window.first, window.last, threads)
    states = states_of(sums, window, progress)
    data = ring_data(sums, states, window, P, Q)
    del data["lives"]
    return {**data, "passages": _passages(P, Q, used, states.scales, len(sums.edges()))}


def _passages(
    P: _core.PolygonSet,
    Q: _core.PolygonSet,
    used: Sequence[Fraction],
    events: list[str],
    edges: int,
) -> dict[str, Any] | None:
    """Map exact scales to tight passages: always for scales of copies, for events if time allows;
    None if even copies have too many scales."""
    own = list(map(str, sorted(set(used))))
    for scales in (sorted({*own, *events}, key=Fraction), own):
        found = passages_at(P, Q, scales, edges)
        if found is not None:
            return {scales[int(number)]: lines for number, lines in found.items()}
    return None


def _key(shape: _core.PolygonSet) -> str:
    """Equal shapes share a text; canonical forms lack points and segments."""
    return shape.canonical_json() if shape.is_region else shape.to_json()


def _set(operand: _core.PolygonSet) -> dict[str, Any]:
    """Rings in doubles, and the exact set as scene files write it."""
    return {"rings": rings_of(operand), "set": json.loads(operand.to_json())}


def _refuse_beyond_doubles(copies: Sequence[CopyRow]) -> None:
    """Refuse numbers that round to infinity, and scales that round to zero."""
    for number, copy in enumerate(copies):
        where = f"copy {number}"
        scale = Fraction(copy.scale)
        ends = [
            double(end, f"a scale around that of {where}") for end in (scale / ROOM, scale * ROOM)
        ]
        if ends[0] == 0:
            what = "the scale is too small for a double, which a browser draws with"
            raise Refusal(what, f"{where}, scale", "scale the shape instead", "limit")
        for axis in (copy.x, copy.y):
            double(Fraction(axis), f"the place of {where}")
