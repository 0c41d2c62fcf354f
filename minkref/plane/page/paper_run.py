"""The paper's own program along the slider of the page: its answers beside the exact sums."""

from __future__ import annotations

import math
from collections.abc import Callable
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.cli.paper_words import in_words
from minkref.cli.progress import progress
from minkref.plane.operand import Operand
from minkref.plane.page.boundary import Window, rings_of
from minkref.plane.page.linear import double
from minkref.verbs.paper_options import Program
from minkref.verbs.paper_update import PaperWalk, decided, paper_walk

MOST_NUMBERS = 1_000_000  # coordinates of lost and added parts on a page
MOST_EVENTS = 200  # that are missed, and as many that are invented
DIGITS = 9
UNDECIDED = "no answer: the arithmetic could not decide a sign"

Polygons = list[list[list[float]]]


def slider_scales(window: Window, count: int) -> list[str]:
    """`count` scales, or as many as doubles tell apart, evenly spaced on the logarithmic slider:
    the ends of the window, and short numbers between them. Ascending, exact."""
    begin, end = Fraction(window.first), Fraction(window.last)
    growth = math.exp((math.log(end) - math.log(begin)) / (count - 1))
    digits = min(max(3 - math.floor(math.log10(max(growth - 1, 1e-16))), 4), 17)
    first = float(begin)
    found = {Fraction(f"{first * growth**k:.{digits}g}") for k in range(1, count - 1)}
    between = sorted(scale for scale in found if begin < scale < end)
    return [window.first, *map(str, between), window.last]


def paper_run(
    P: Operand, Q: Operand, window: Window, program: Program, exact: Callable[[str], _core.Sum]
) -> dict[str, Any]:
    """The field `paper` of the page's data: docs/command-line.md, "minkref view". The walk begins
    at the smallest scale and goes through the others in their order. Exact but for what is drawn:
    the parts that an answer has lost and added, as doubles, where they are not too many for the
    page. Refuses what the arithmetic cannot decide on the way."""
    scales = slider_scales(window, program.steps)
    room = MOST_NUMBERS // len(scales)
    steps = []
    with progress(len(scales)) as line:
        line.now("finding the paper's events")
        walk = paper_walk(P, Q, scales[0], program.arithmetic, program.readings)
        line.now("scales")
        for scale in scales:
            steps.append(_step(walk, scale, exact(scale), room))
            line.done()
        line.now("comparing events")
        events = walk.events(MOST_EVENTS, (Fraction(window.first), Fraction(window.last)))
    listed = {name: events.pop(f"{name}_within") for name in ("missed", "invented")}
    return {
        **program.fields(),
        "steps": steps,
        "events": events,
        **{name: [_event(event) for event in rows] for name, rows in listed.items()},
    }


def _step(walk: PaperWalk, scale: str, truth: _core.Sum, room: int) -> dict[str, Any]:
    step: dict[str, Any] = {
        "scale": scale,
        "about": double(Fraction(scale), "a scale"),
        "right": False,
        "words": UNDECIDED,
        "witness": None,
        "lost": [],
        "added": [],
    }
    decided(lambda: walk.move_to(scale))
    try:
        answer = walk.sum()
    except _core.UndecidedSign:
        return step
    found = walk.beside_exact(scale, answer, truth)
    step |= {"right": found["same_structure"], "words": in_words(found)}
    if step["right"]:
        return step
    if found["witness"] is not None:
        step["witness"] = [
            _rounded(double(Fraction(axis), "a coordinate")) for axis in found["witness"]["point"]
        ]
    lost = _drawn(_core.minus(truth.region, answer.region))
    added = _drawn(_core.minus(answer.region, truth.region))
    fits = _numbers(lost) + _numbers(added) <= room
    return step | ({"lost": lost, "added": added} if fits else {"lost": None, "added": None})


def _drawn(region: _core.PolygonSet) -> Polygons:
    return [[[_rounded(axis) for axis in ring] for ring in polygon] for polygon in rings_of(region)]


def _numbers(polygons: Polygons) -> int:
    return sum(len(ring) for polygon in polygons for ring in polygon)


def _rounded(number: float) -> float:
    return float(f"{number:.{DIGITS}g}")


def _event(event: dict[str, Any]) -> dict[str, Any]:
    return {**event, "about": double(Fraction(event["scale"]), "a scale")}
