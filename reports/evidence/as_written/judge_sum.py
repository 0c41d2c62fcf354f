"""Every writer and table of `minkref sum P disc:R` against the canonical form."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from typing import Any

import gmpy2
from minkref.reports.evidence.as_written import (
    bulges,
    expressions,
    pictures,
    places,
    read_dxf,
    read_plane,
)
from minkref.reports.evidence.as_written.answers import Answers, Document
from minkref.reports.evidence.as_written.covering import Neighbourhood
from minkref.reports.evidence.as_written.curves import Grown, grown
from minkref.reports.evidence.as_written.distance import Ring, to_segment
from minkref.reports.evidence.as_written.inputs_disc import Drawn
from minkref.reports.evidence.as_written.measures import area_and_length
from minkref.reports.evidence.as_written.polygons import Asked
from minkref.reports.evidence.as_written.tally import Tally, told
from minkref.reports.evidence.as_written.units import TIE, Real, exact, exact_double, unit

GREATEST = gmpy2.mpq(2) ** 1023  # smaller numbers are surely in the doubles' range
WIDEST = 2  # most units in the last place for an enclosure
OFF_INDEX = gmpy2.mpq(1, 2**36)  # relative, for areas and lengths at any radius (docs/disc.md)
READERS: dict[str, Callable[[str], read_plane.Polygons]] = {
    "wkt": read_plane.wkt, "geojson": read_plane.geojson, "poly": read_plane.poly,
}  # fmt: skip
MEASURE = re.compile(
    r"^(area|length of the boundary) +(beyond doubles|\S+?)(?:, within (\S+))?$", re.M
)
PASSAGE = re.compile(r"\((\S+), (\S+)\)")


def rings_of(drawn: Drawn) -> list[Ring]:
    return [
        [(gmpy2.mpq(x), gmpy2.mpq(y)) for x, y in ring]
        for polygon in drawn.polygons
        for ring in polygon
    ]


def judge(tally: Tally, answers: Answers, drawn: Drawn) -> None:
    words = ("sum", drawn.text, drawn.radius)
    document = answers.document(*words, "--measures")
    of, rings = grown(document["result"]), rings_of(drawn)
    measures = dict(zip(("area", "length"), area_and_length(of), strict=True))
    _true_corners(tally, of, rings)
    _document(tally, document, of, measures)
    for ending in ("dxf", "svg"):
        with tally.answer(f".{ending}"):
            text, table = answers.file(ending, *words)
            _table(tally, table, measures, document)
            if ending == "dxf":
                _dxf(tally, text, of)
            else:
                pictures.judge(tally, ".svg", text, of, rings)
    _polygons(tally, answers, words, Asked(rings, of, _tolerance(of)))


def _tolerance(of: Grown) -> Any:
    """A twentieth of the radius, as a short number."""
    exponent = math.floor(gmpy2.log10(of.radius / 20))
    return gmpy2.mpq(10) ** exponent


def _true_corners(tally: Tally, of: Grown, rings: list[Ring]) -> None:
    """The judge's own corners: as far from the set as the radius, to 300 digits."""
    around = Neighbourhood(rings, of.squared)
    for piece in (piece for ring in of.rings for piece in ring):
        if piece.start is None:
            continue
        tally.numbers["corners of the judge"] += 1
        least = min(to_segment(piece.start, edge) for edge in around.edges)
        if abs(least - of.squared) > of.squared * gmpy2.mpq(1, 2**600):
            tally.fault(
                "corners of the judge", "not as far from the set as the radius", told(least)
            )


def _document(tally: Tally, document: Document, of: Grown, true: dict[str, Real]) -> None:
    for name, value in true.items():
        bounds(tally, "sum --json", document[name], value, name)
        terms = _terms(document["measures"], name, of)
        if abs(terms - value) > abs(value) * gmpy2.mpq(1, 2**300):
            tally.fault("--measures", "another number", f"{name} {told(terms)}, true {told(value)}")
        tally.numbers["--measures"] += 1
    for passage in document["tight_passages"]:
        for words, near in zip(passage["points"], passage["near"], strict=True):
            for word, number in zip(words, near, strict=True):
                tally.number("tight passages", number, expressions.value(word), f"near of {word}")


def _terms(measures: Document, name: str, of: Grown) -> Real:
    total = sum(
        (exact(one["factor"]) * expressions.value(one["root"]) for one in measures[name]),
        gmpy2.mpq(0),
    )
    turned = gmpy2.mpfr(0)
    for one in measures["angles"]:
        (ax, ay), (bx, by) = ([expressions.value(x) for x in one[end]] for end in ("from", "to"))
        at = gmpy2.atan2(gmpy2.mpfr(ax * by - ay * bx), gmpy2.mpfr(ax * bx + ay * by))
        turned += at if at > 0 else at + 2 * gmpy2.const_pi()
    return total + (of.squared / 2 if name == "area" else of.radius) * turned


def bounds(
    tally: Tally, writer: str, found: Document, true: Real, name: str, off_index: bool = False
) -> None:
    """Checks that two doubles enclose the true number, at most WIDEST units apart; values read off
    an index may lie OFF_INDEX times the number apart."""
    tally.numbers[writer] += 2
    if found["low"] is None or found["high"] is None:
        if abs(true) < GREATEST:
            tally.fault(writer, "null in place of a number", f"{name}, true {told(true)}")
        return
    low, high = float(found["low"]), float(found["high"])
    if not (math.isfinite(low) and math.isfinite(high)):
        tally.fault(writer, "NaN or infinity", f"{name} {low} to {high}")
        return
    tie = abs(true) * TIE
    if not exact_double(low) - tie <= true <= exact_double(high) + tie:
        tally.fault(
            writer,
            "an enclosure without the value",
            f"{name} {low!r} to {high!r}, true {told(true)}",
        )
    wide = (exact_double(high) - exact_double(low)) / unit(true)
    if wide > (abs(true) * OFF_INDEX / unit(true) if off_index else WIDEST):
        shown = f"{name} {low!r} to {high!r}, true {told(true)}"
        tally.fault(writer, f"an enclosure wider than {places.scale_of(wide)} units", shown)


def _table(tally: Tally, table: str, true: dict[str, Real], document: Document) -> None:
    found = MEASURE.findall(table)
    if len(found) != 2:
        tally.fault("table of sum", "no area or no length", table[:300])
    for name, number, within in found:
        value = true[name.split()[0]]
        if number == "beyond doubles":
            if abs(value) < GREATEST:
                tally.fault("table of sum", "a double is said to be beyond doubles", told(value))
            continue
        tally.printed("table of sum", number, value, name)
        if within:
            off = abs(exact(number) - value)
            if off > exact(within):
                tally.fault(
                    "table of sum", "an enclosure without the value", f"{number}, within {within}"
                )
    shown = [pair for line in table.splitlines() for pair in PASSAGE.findall(line)]
    points = [point for one in document["tight_passages"] for point in one["points"]]
    if len(shown) == len(points):
        for pair, point in zip(shown, points, strict=True):
            for number, word in zip(pair, point, strict=True):
                if number != word:
                    tally.printed(
                        "table of sum", number, expressions.value(word), "a tight passage"
                    )


def _dxf(tally: Tally, text: str, of: Grown) -> None:
    rings = read_dxf.polylines(text)
    places.compare(tally, ".dxf", places.doubles((x, y) for ring in rings for x, y, _ in ring), of)
    for ring in rings:
        bulges.compare(tally, ring, of)


def _polygons(tally: Tally, answers: Answers, words: tuple[str, ...], asked: Asked) -> None:
    """Judges a polygon inside the sum in every format, and a polygon around the sum in one format,
    chosen by the radius."""
    turn = sum(map(ord, words[-1])) % len(READERS)
    for number, (ending, reader) in enumerate(READERS.items()):
        for outside in (False, True) if number == turn else (False,):
            writer = f".{ending} {'outside' if outside else 'inside'}"
            with tally.answer(writer):
                more = ["--tolerance", str(asked.tolerance), *(["--outside"] if outside else [])]
                text, _ = answers.file(ending, *words, *more)
                asked.judge(tally, writer, reader(text), outside)
