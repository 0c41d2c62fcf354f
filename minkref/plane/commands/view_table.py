"""The counts and lines that `minkref view` prints about the page in the plane."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from minkref.cli.output import print_lines
from minkref.cli.paper_words import events_in_words
from minkref.exact import rounded


def counts(data: dict[str, Any]) -> dict[str, Any]:
    changes = [state for state in data["states"] if state]
    return {
        "segments": {kind: len(data[kind]) // 2 for kind in ("S", "T")},
        "boundary_events": len(data["scales"]),
        "topology_events": len(data["topology"]),
        "holes": sum(life is not None for life in data["holes"][1:]),
        "components": sum(life is not None for life in data["components"]),
        "tracks": len(data["tracks"]) // 4,
        "splices": sum(len(ring) - 4 for state in changes for ring in state[1:]),
    }


def counts_of_erosion(data: dict[str, Any]) -> dict[str, Any]:
    """The same with the holes of the sum as components of the erosion, and its components, but for
    that of the box, as holes."""
    found = counts(data)
    return {**found, "holes": found["components"] - 1, "components": found["holes"]}


def print_view(value: dict[str, Any]) -> None:
    window = f"[{value['from']}, {value['to']}]"
    if Fraction(value["from"]).denominator > 10**6 or Fraction(value["to"]).denominator > 10**6:
        window += f", about [{rounded(value['from'], 6)}, {rounded(value['to'], 6)}]"
    segments = value["segments"]
    sign = "less" if value["erode"] else "+"
    rows = [
        (f"sP {sign} Q", f"{value['P']} {sign} {value['Q']}"),
        ("window", window),
        ("route", value["route"]),
        ("edges", f"{segments['S']:,} S, {segments['T']:,} T"),
        ("boundary events", f"{value['boundary_events']:,}"),
        ("topology events", f"{value['topology_events']:,}"),
        ("holes ever", f"{value['holes']:,}"),
        ("components ever", f"{value['components']:,}"),
        ("vertices ever", f"{value['tracks']:,}"),
        *_of_the_paper(value),
        ("seconds", f"{value['seconds']:.3f}"),
        ("written", f"{value['output']}, {value['bytes']:,} bytes"),
    ]
    print_lines(rows, value)


def _of_the_paper(value: dict[str, Any]) -> list[tuple[str, str]]:
    if value["steps"] is None:
        return []
    wrong = f"{value['wrong_steps']:,} of {value['steps']:,}"
    first = value["first_wrong"]
    at = "" if first is None else f", the first at {rounded(first, 6)}"
    return [
        ("paper", f"{value['arithmetic']}, wrong at {wrong} scales{at}"),
        *events_in_words(value["events"]),
    ]
