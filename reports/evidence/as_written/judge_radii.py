"""`minkref sweep P disc` and `minkref.DiscIndex` at several radii, against the canonical form of
each radius."""

from __future__ import annotations

import json
import math
import re
from fractions import Fraction
from typing import Any

import minkref
from minkref.reports.evidence.as_written.answers import Answers
from minkref.reports.evidence.as_written.curves import grown
from minkref.reports.evidence.as_written.inputs_disc import Drawn
from minkref.reports.evidence.as_written.judge_sum import bounds
from minkref.reports.evidence.as_written.measures import area_and_length
from minkref.reports.evidence.as_written.tally import Tally, told
from minkref.reports.evidence.as_written.units import exact_double

ROW = re.compile(r"^ *(\d\S*) +(\S+) +(\d+) +(\d+) +(\d+) +(\S+)(?: .*)?$", re.M)
STEPS = 3
SLACK = 1 + Fraction(1, 2**40)  # for the roundings of the bound itself


def window(drawn: Drawn) -> tuple[Fraction, Fraction]:
    """From half the disc's radius to the radius, if rational; otherwise both ends are doubles."""
    text = drawn.radius.removeprefix("disc:")
    if text.startswith("sqrt:"):
        radius = Fraction(math.sqrt(Fraction(text.removeprefix("sqrt:"))))
    else:
        radius = Fraction(text)
    return radius / 2, radius


def judge(tally: Tally, answers: Answers, drawn: Drawn) -> None:
    low, high = window(drawn)
    index = minkref.DiscIndex(minkref.PolygonSet(drawn.text))
    radii = [low + (high - low) * k / (STEPS - 1) for k in range(STEPS)]
    sums = [grown(json.loads(index.canonical_json(radius))) for radius in radii]
    words = ("sweep", drawn.text, "disc", "--from", low, "--to", high, "--steps", STEPS)
    with tally.answer("sweep --json"):
        rows = answers.document(*words)["rows"]
        for row, of in zip(rows, sums, strict=True):
            for name, true in zip(("area", "length"), area_and_length(of), strict=True):
                bounds(tally, "sweep --json", row[name], true, name, off_index=True)
    with tally.answer("table of sweep"):
        lines = ROW.findall(answers.table(*words))
        if len(lines) != len(sums):
            tally.fault("table of sweep", "more or fewer lines than radii", str(len(lines)))
        for line, of in zip(lines, sums, strict=False):
            tally.printed("table of sweep", line[1], area_and_length(of)[0], "area")
    for radius, of in zip(radii, sums, strict=True):
        for (a, b), true in zip(index.area_and_length(radius), area_and_length(of), strict=True):
            found = {"low": a, "high": b}
            bounds(tally, "DiscIndex.area_and_length", found, true, "area or length", True)
    _vertices(tally, index, (low + high) / 2, drawn)
    offset = minkref.offset(minkref.PolygonSet(drawn.text), high)
    for (a, b), true in zip((offset.area, offset.length), area_and_length(sums[-1]), strict=True):
        bounds(tally, "minkref.offset", {"low": a, "high": b}, true, "area or length")


def _vertices(tally: Tally, index: Any, radius: Fraction, drawn: Drawn) -> None:
    """Judges rows of x, y and an error bound for both, at a double radius. The bound holds, and
    stays as small as docs/disc.md says; no corner may be missing."""
    at = float(radius)
    of = grown(json.loads(index.canonical_json(Fraction(at))))
    rows = [tuple(map(float, row)) for row in index.vertices(at)[0]]
    writer = "DiscIndex.vertices"
    tally.numbers[writer] += 3 * len(rows)
    finite = [row for row in rows if all(map(math.isfinite, row))]
    for row in set(rows).difference(finite):
        tally.fault(writer, "NaN or infinity", str(row))
    corners = [piece.start for ring in of.rings for piece in ring if piece.start is not None]
    widest = (_size(drawn) + Fraction(at)) * Fraction(1, 2**42)
    for x, y, bound in finite:
        coordinates = Fraction(max(abs(x), abs(y))) * Fraction(1, 2**50)
        if Fraction(bound) > (widest + coordinates) * SLACK:
            tally.fault(writer, "a bound wider than is said", f"({x!r}, {y!r}), bound {bound!r}")
        if corners and not any(_within((x, y), corner, bound) for corner in corners):
            tally.fault(writer, "no corner is within the bound", f"({x!r}, {y!r}), bound {bound!r}")
    for corner in corners:
        if not any(_within((x, y), corner, bound) for x, y, bound in finite):
            tally.fault(writer, "a corner is missing", f"({told(corner[0])}, {told(corner[1])})")


def _size(drawn: Drawn) -> Fraction:
    """The longer side of the box."""
    columns = zip(*(point for ring in drawn.rings for point in ring), strict=True)
    return max(Fraction(max(column)) - Fraction(min(column)) for column in columns)


def _within(place: tuple[float, float], corner: tuple[Any, Any], bound: float) -> bool:
    return all(
        abs(exact_double(a) - b) <= exact_double(bound) for a, b in zip(place, corner, strict=True)
    )
