"""Judges every writer and table for sums of two sets in the plane against exact numbers."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import Any

import gmpy2
import minkref
from minkref.reports.evidence.as_written import read_plane
from minkref.reports.evidence.as_written.answers import Answers, Document
from minkref.reports.evidence.as_written.inputs_plane import Pair
from minkref.reports.evidence.as_written.read_plane import Polygons
from minkref.reports.evidence.as_written.read_svg import Step, paths
from minkref.reports.evidence.as_written.tally import Tally, told
from minkref.reports.evidence.as_written.units import exact, exact_double

READERS: dict[str, Callable[[str], Polygons]] = {
    "wkt": read_plane.wkt, "geojson": read_plane.geojson, "poly": read_plane.poly,
    "json": read_plane.plain_json,
}  # fmt: skip
AREA = re.compile(r"^(?:area|volume) +(?:(\S+), )?(?:about )?(\S+)(?: = (.+)| \(.+\))?$", re.M)
BOX = re.compile(r">x (\S+) to (\S+), y (\S+) to ([^\s<]+)<")
ROW = re.compile(r"^ *(\d\S*) +(\S+) +(\d+) +(\d+) +(\d+) +(\S+)(?: .*)?$", re.M)
PICTURE = 0.02  # units; allows for two decimals and a measured scale
STEPS = 3


def numbers(polygons: Polygons) -> Iterator[str]:
    for ring in (ring for polygon in polygons for ring in polygon):
        for pair in ring:
            yield from pair


def area_of(polygons: Polygons) -> Any:
    """Exactly, in rational numbers."""
    total = gmpy2.mpq(0)
    for ring in (ring for polygon in polygons for ring in polygon):
        places = [(exact(x), exact(y)) for x, y in ring]
        for (ax, ay), (bx, by) in zip(places, (*places[1:], places[0]), strict=True):
            total += ax * by - ay * bx
    return total / 2


def judge(tally: Tally, answers: Answers, pair: Pair) -> None:
    words = ("sum", pair.P, pair.Q, "--scale", pair.scale)
    document = answers.document(*words)
    polygons = read_plane.polygons_of(document["result"])
    area = area_of(polygons)
    tally.numbers["sum --json"] += 2
    if exact(document["area"]) != area:
        tally.fault("sum --json", "an area that is not exact", document["area"])
    approximate(tally, "sum --json", document["area_approximate"], area)
    for ending, reader in READERS.items():
        with tally.answer(f".{ending}"):
            text, table = answers.file(ending, *words)
            _file(tally, f".{ending}", reader(text), polygons, "rounded" not in table)
            area_told(tally, "table of sum", table, area)
    with tally.answer(".svg"):
        text, _ = answers.file("svg", *words)
        _picture(tally, text, polygons)
    _sweep(tally, answers, pair)
    _arrays(tally, pair)


def approximate(tally: Tally, writer: str, number: str | None, true: Any) -> None:
    if number is not None:
        tally.number(writer, number, true, "area or volume, approximate")
    elif abs(true) < gmpy2.mpq(2) ** 1023:
        tally.fault(writer, "null in place of a number", f"true {told(true)}")


def area_told(tally: Tally, writer: str, table: str, true: Any) -> None:
    """Judges an area: a fraction with a rounded number, or one number; no `=` stands beside a
    rounded number."""
    found = AREA.search(table)
    if not found:
        tally.fault(writer, "no area or volume", table[:300])
        return
    fraction, number, equal = found.groups()
    for text in filter(None, (fraction, number)):
        if "/" not in text:
            tally.printed(writer, text, true, "area or volume")
        elif exact(text) != true:
            tally.fault(writer, "digits that are not certain", text)
    tally.numbers[writer] += 1
    if equal and exact(number) != true:
        tally.fault(writer, "`=` beside a rounded number", found[0][:120])


def _file(tally: Tally, writer: str, found: Polygons, true: Polygons, said_exact: bool) -> None:
    texts, trues = list(numbers(found)), [exact(text) for text in numbers(true)]
    if len(texts) != len(trues):
        tally.fault(writer, "more or fewer numbers than the sum has", f"{len(texts)}, {len(trues)}")
        return
    for text, value in zip(texts, trues, strict=True):
        tally.number(writer, text, value, "a coordinate")
        tally.number(f"{writer} as doubles", repr(float(Fraction(text))), value, "a coordinate")
    if said_exact and any(exact(text) != value for text, value in zip(texts, trues, strict=True)):
        tally.fault(writer, "not exact, and not said", "")


def _picture(tally: Tally, text: str, polygons: Polygons) -> None:
    """Judges the box in words, and the sum's corners by the map from the sum's box to the drawn
    box."""
    places = [(exact(x), exact(y)) for one in polygons for ring in one for x, y in ring]
    xs, ys = zip(*places, strict=True)
    for found, true in zip(
        BOX.findall(text)[-1], (min(xs), max(xs), min(ys), max(ys)), strict=True
    ):
        if "/" not in found:
            tally.printed(".svg", found, true, "the box of the sum")
        elif exact(found) != true:
            tally.fault(".svg", "digits that are not certain", found)
    picture(tally, ".svg", paths(text)["sum"], polygons)


def picture(tally: Tally, writer: str, rings: list[list[Step]], polygons: Polygons) -> None:
    """Looks for each of the sum's corners at the mapped place; the map takes box to box."""
    places = [(exact(x), exact(y)) for one in polygons for ring in one for x, y in ring]
    xs, ys = zip(*places, strict=True)
    drawn = [(float(s.x), float(s.y)) for ring in rings for s in ring]
    tally.numbers[writer] += 2 * len(drawn)
    wide = max(max(xs) - min(xs), max(ys) - min(ys))
    true_places = [(float((x - min(xs)) / wide), float((max(ys) - y) / wide)) for x, y in places]
    left, top = (min(one) for one in zip(*drawn, strict=True))
    size = max(max(one) - min(one) for one in zip(*drawn, strict=True))
    for x, y in true_places:
        at = left + size * x, top + size * y
        if not any(abs(at[0] - a) <= PICTURE and abs(at[1] - b) <= PICTURE for a, b in drawn):
            tally.fault(writer, "a corner is not in the picture", f"{at}")


def _sweep(tally: Tally, answers: Answers, pair: Pair) -> None:
    high = Fraction(pair.scale)
    words = ("sweep", pair.P, pair.Q, "--from", high / 2, "--to", high, "--steps", STEPS)
    with tally.answer("sweep"):
        rows: list[Document] = answers.document(*words)["rows"]
        for row in rows:
            approximate(tally, "sweep --json", row["area_approximate"], exact(row["area"]))
        lines = ROW.findall(answers.table(*words))
        if len(lines) != len(rows):
            tally.fault("table of sweep", "more or fewer lines than scales", str(len(lines)))
        for line, row in zip(lines, rows, strict=False):
            if "/" not in line[1]:
                tally.printed("table of sweep", line[1], exact(row["area"]), "area")
            elif exact(line[1]) != exact(row["area"]):
                tally.fault("table of sweep", "digits that are not certain", line[1])


def _arrays(tally: Tally, pair: Pair) -> None:
    """Judges doubles from `ScaleIndex`, each with an error bound that must hold."""
    P, Q = (minkref.PolygonSet(text) for text in (pair.P, pair.Q))
    index = minkref.build_index(P, Q, Fraction(pair.scale) / 2, pair.scale)
    value, error = index.area(pair.scale)
    true = sum(
        exact(str(a)) * exact(pair.scale) ** k
        for k, a in enumerate(index.area_polynomial(pair.scale))
    )
    _bounded(tally, "ScaleIndex.area", value, error, true)
    rings, rational = (
        index.rings(pair.scale, "double"),
        index.rings(pair.scale, "rational").rational,
    )
    for x, y, row in zip(rings.x, rings.y, rational, strict=True):
        a, b, c, d = (int.from_bytes(words.tobytes(), "little", signed=True) for words in row)
        _bounded(tally, "ScaleIndex.rings", float(x), rings.error, gmpy2.mpq(a, b))
        _bounded(tally, "ScaleIndex.rings", float(y), rings.error, gmpy2.mpq(c, d))
    for polygon, told_by in zip(P.arrays(), read_plane.wkt(pair.P), strict=True):
        for array, ring in zip(polygon, told_by, strict=True):
            for found, true_pair in zip(array.tolist(), ring, strict=True):
                for number, text in zip(found, true_pair, strict=True):
                    tally.number("PolygonSet.arrays", repr(number), exact(text), "a coordinate")


def _bounded(tally: Tally, writer: str, value: float, error: float, true: Any) -> None:
    tally.numbers[writer] += 1
    if not (math.isfinite(value) and math.isfinite(error)):
        tally.fault(writer, "NaN or infinity", f"{value} within {error}, true {told(true)}")
    elif abs(exact_double(value) - true) > exact_double(error):
        tally.fault(
            writer,
            "an enclosure without the value",
            f"{value!r} within {error!r}, true {told(true)}",
        )
