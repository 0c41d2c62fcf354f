"""`minkref sweep P disc` and `minkref.OffsetIndex` at several radii, against the canonical form of
each radius."""

from __future__ import annotations

import json
import math
import re
from fractions import Fraction
from typing import Any

import minkref
from minkref.reports.evidence.written import places
from minkref.reports.evidence.written.answers import Answers
from minkref.reports.evidence.written.curves import grown
from minkref.reports.evidence.written.inputs_disc import Drawn
from minkref.reports.evidence.written.judge_sum import bounds
from minkref.reports.evidence.written.measures import area_and_length
from minkref.reports.evidence.written.tally import Tally
from minkref.reports.evidence.written.units import exact_double

ROW = re.compile(r"^ *(\d\S*) +(\S+) +(\d+) +(\d+) +(\d+) +(\S+)(?: .*)?$", re.M)
STEPS = 3


def window(drawn: Drawn) -> tuple[Fraction, Fraction]:
    """From half of the disc to the whole, where that is rational; else from and to doubles."""
    told = drawn.radius.removeprefix("disc:")
    if told.startswith("sqrt:"):
        radius = Fraction(math.sqrt(Fraction(told.removeprefix("sqrt:"))))
    else:
        radius = Fraction(told)
    return radius / 2, radius


def judge(tally: Tally, answers: Answers, drawn: Drawn) -> None:
    low, high = window(drawn)
    index = minkref.OffsetIndex(minkref.PolygonSet(drawn.text))
    radii = [low + (high - low) * k / (STEPS - 1) for k in range(STEPS)]
    sums = [grown(json.loads(index.canonical_json(radius))) for radius in radii]
    words = ("sweep", drawn.text, "disc", "--from", low, "--to", high, "--steps", STEPS)
    with tally.answer("sweep --json"):
        rows = answers.document(*words)["rows"]
        for row, of in zip(rows, sums, strict=True):
            for name, true in zip(("area", "length"), area_and_length(of), strict=True):
                bounds(tally, "sweep --json", row[name], true, name)
    with tally.answer("table of sweep"):
        lines = ROW.findall(answers.table(*words))
        if len(lines) != len(sums):
            tally.fault("table of sweep", "more or fewer lines than radii", str(len(lines)))
        for line, of in zip(lines, sums, strict=False):
            tally.printed("table of sweep", line[1], area_and_length(of)[0], "area")
    for radius, of in zip(radii, sums, strict=True):
        for (a, b), true in zip(index.area_and_length(radius), area_and_length(of), strict=True):
            bounds(
                tally, "OffsetIndex.area_and_length", {"low": a, "high": b}, true, "area or length"
            )
    _vertices(tally, index, (low + high) / 2)
    offset = minkref.offset(minkref.PolygonSet(drawn.text), high)
    for (a, b), true in zip((offset.area, offset.length), area_and_length(sums[-1]), strict=True):
        bounds(tally, "minkref.offset", {"low": a, "high": b}, true, "area or length")


def _vertices(tally: Tally, index: Any, radius: Fraction) -> None:
    """Rows x, y and a bound of the error of both, for a radius that is a double."""
    at = float(radius)
    of = grown(json.loads(index.canonical_json(Fraction(at))))
    rows = [tuple(map(float, row)) for row in index.vertices(at)[0]]
    writer = "OffsetIndex.vertices"
    places.compare(tally, writer, [(x, y) for x, y, _ in rows], of)
    corners = [piece.start for ring in of.rings for piece in ring if piece.start is not None]
    for x, y, bound in rows:
        if not all(map(math.isfinite, (x, y, bound))):
            continue  # counted already, but for the bound
        if not any(_within((x, y), corner, bound) for corner in corners) and corners:
            tally.fault(writer, "no corner is within the bound", f"({x!r}, {y!r}), bound {bound!r}")


def _within(place: tuple[float, float], corner: tuple[Any, Any], bound: float) -> bool:
    return all(
        abs(exact_double(a) - b) <= exact_double(bound) for a, b in zip(place, corner, strict=True)
    )
