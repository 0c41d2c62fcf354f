"""Judges the page data of two sets in the plane, and a sweep's pictures, against exact numbers."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import gmpy2
import minkref
from minkref.reports.evidence.as_written import read_plane
from minkref.reports.evidence.as_written.answers import Answers, Document
from minkref.reports.evidence.as_written.inputs_plane import Pair
from minkref.reports.evidence.as_written.judge_plane import picture
from minkref.reports.evidence.as_written.read_page import page_data
from minkref.reports.evidence.as_written.read_plane import load
from minkref.reports.evidence.as_written.read_svg import paths
from minkref.reports.evidence.as_written.tally import Tally
from minkref.reports.evidence.as_written.units import exact, exact_double, is_double_of

PAGE, PICTURES = "page of view", "pictures of sweep"
STEPS = 2


def judge(tally: Tally, answers: Answers, pair: Pair) -> None:
    high = Fraction(pair.scale)
    window = ("--from", high / 2, "--to", high)
    with tally.answer(PAGE):
        _page(tally, page_data(answers, "view", pair.P, pair.Q, *window), pair)
    with tally.answer(PICTURES):
        _pictures(tally, answers, (pair.P, pair.Q, *window, "--steps", STEPS))


def _page(tally: Tally, data: Document, pair: Pair) -> None:
    high = Fraction(pair.scale)
    P, Q = (minkref.PolygonSet(text) for text in (pair.P, pair.Q))
    index = minkref.build_index(P, Q, high / 2, high)
    for text, written in zip((pair.P, pair.Q), (data["P"], data["Q"]), strict=True):
        trues = [
            axis for polygon in read_plane.wkt(text) for ring in polygon for axis in _axes(ring)
        ]
        numbers = [axis for polygon in written for ring in polygon for axis in ring]
        for number, true in zip(numbers, trues, strict=True):
            tally.number(PAGE, number, exact(true), "a coordinate")
    for number, true in zip(data["about"], data["scales"], strict=True):
        tally.number(PAGE, number, exact(true), "a scale")
    events = [row for row in index.boundary_events() if row[0] in set(data["scales"])]
    places = [axis for row in events for axis in row[3]]
    for number, true in zip(data["places"], places, strict=True):
        tally.number(PAGE, number, exact(str(true)), "a place")
    _tracks(tally, data, [(*map(_number, a), *map(_number, b)) for a, b in index.tracks()])


def _axes(ring: Any) -> Iterator[str]:
    for x, y in ring:
        yield x
        yield y


def _number(value: Any) -> Any:
    return gmpy2.mpq(Fraction(value).numerator, Fraction(value).denominator)


def _tracks(tally: Tally, data: Document, every: list[Any]) -> None:
    """Checks that each line on a page, x = r + m (s - c) and y likewise, equals an exact line."""
    numbers, centres = [exact(text) for text in data["tracks"]], data["centres"]  # read as doubles
    for track in range(len(numbers) // 4):
        rx, mx, ry, my = numbers[4 * track : 4 * track + 4]
        cx, cy = (exact_double(float(centres.get(str(2 * track + k), 0))) for k in (0, 1))
        tally.numbers[PAGE] += 4
        if not any(
            is_double_of(mx, u) and is_double_of(my, v)
            and is_double_of(rx, a + u * cx) and is_double_of(ry, b + v * cy)
            for a, b, u, v in every
        ):  # fmt: skip
            told = " ".join(data["tracks"][4 * track : 4 * track + 4])
            tally.fault(PAGE, "a line that is no line of the sum", told)


def _pictures(tally: Tally, answers: Answers, words: tuple[object, ...]) -> None:
    """Judges the same sum at each scale, exact and drawn."""
    exactly, drawn = answers.folder / "exactly", answers.folder / "drawn"
    for folder in (exactly, drawn):
        shutil.rmtree(folder, ignore_errors=True)
    answers.table("sweep", *words, "-o", exactly)
    answers.table("sweep", *words, "-o", drawn, "--format", "svg")
    for number in range(1, STEPS + 1):
        sums = load((exactly / f"sum-{number:04}.json").read_text(encoding="utf-8"))
        rings = paths(answers.read(drawn / f"sum-{number:04}.svg"))[""]
        picture(tally, PICTURES, rings, read_plane.polygons_of(sums))
