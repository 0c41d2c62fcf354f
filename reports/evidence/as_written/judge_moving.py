"""Events and the convolution of two sets in the plane: lists, tables, GeoJSON and columns against
the exact numbers beside them."""

from __future__ import annotations

import re

import pyarrow.parquet as parquet
from minkref.reports.evidence.as_written.answers import Answers
from minkref.reports.evidence.as_written.inputs_plane import Pair
from minkref.reports.evidence.as_written.read_plane import load
from minkref.reports.evidence.as_written.read_table import boxed
from minkref.reports.evidence.as_written.tally import Tally
from minkref.reports.evidence.as_written.units import exact

SHOWN = 6  # rows of a table
PLACE = re.compile(r"\(([^ ,]+), ([^ ,)]+)\)")


def judge(tally: Tally, answers: Answers, pair: Pair) -> None:
    with tally.answer("events"):
        _events(tally, answers, pair)
    with tally.answer("convolution"):
        _convolution(tally, answers, pair)


def _events(tally: Tally, answers: Answers, pair: Pair) -> None:
    words = ("events", pair.P, pair.Q, "--limit", SHOWN)
    events = answers.document(*words)["events"]
    for row, event in zip(boxed(answers.table(*words)), events, strict=False):
        true = exact(event["s"])
        _told(tally, "table of events", row["about"], true, "a scale")
        for found, number in zip(PLACE.findall(row["at"]), [event["at"]], strict=False):
            for text, value in zip(found, number, strict=True):
                _told(tally, "table of events", text, exact(value), "a place")
    path = answers.folder / "events.parquet"
    answers.table("events", pair.P, pair.Q, "-o", path)
    columns = parquet.read_table(path, columns=["s", "s_double"]).to_pydict()
    for text, number in zip(columns["s"], columns["s_double"], strict=True):
        tally.number(".parquet", repr(number), exact(text), "a scale")


def _convolution(tally: Tally, answers: Answers, pair: Pair) -> None:
    words = ("convolution", pair.P, pair.Q, "--scale", pair.scale, "--limit", SHOWN)
    text, _ = answers.file("geojson", *words)
    features = load(text)["features"]
    for feature in features:
        for place, name in zip(feature["geometry"]["coordinates"], ("start", "end"), strict=True):
            for number, true in zip(place, feature["properties"][name], strict=True):
                tally.number("convolution .geojson", number, exact(true), "a coordinate")
    for row, feature in zip(boxed(answers.table(*words)), features, strict=False):
        for column, name in (("from, about", "start"), ("to, about", "end")):
            for found in PLACE.findall(row[column]):
                for text, true in zip(found, feature["properties"][name], strict=True):
                    _told(tally, "table of convolution", text, exact(true), "a coordinate")


def _told(tally: Tally, writer: str, text: str, true: object, name: str) -> None:
    """Judges a printed number: a fraction must be exact, other numbers are rounded."""
    if "/" not in text:
        tally.printed(writer, text, true, name)
    elif exact(text) != true:
        tally.fault(writer, "digits that are not certain", f"{name} is {text}")
