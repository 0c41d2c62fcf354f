"""Events of the plane for people: counts, the first events, and the lives of holes."""

from __future__ import annotations

import sys
from typing import Any

from minkref.cli.paper_words import events_in_words, print_literal
from minkref.exact import rounded
from minkref.output.terminal import console, counted, escaped, lines
from minkref.plane.event_lists import EventList

MEANINGS = {  # of the changes, under the table
    "pair": "birth, death: two edges of the convolution start, or cease, to meet as s grows. Where "
    "holes and components of the sum do, --kind topology says.",
    "parallel": "birth, death: two parallel edges start, or cease, to share a piece as s grows. "
    "Where holes and components of the sum do, --kind topology says.",
    "topology": "before, after: the features that take part, by number; `outside` is no hole.",
}
AS_PRINTED = (
    "As printed: the scales that the interval of Section 4.2.3 gives to each pair, all scales "
    "where no end bounds it, right or wrong. --form corrected counts the pairs that meet."
)
SHOWN = 10  # events that people see
LIVES = 24  # holes and components whose lives people see


def print_events(value: dict[str, Any], found: EventList, count: int) -> None:
    window = f"[{value['from'] or '0'}, {value['to'] or 'oo'}]"
    if value["from"] is None:
        window = "(" + window[1:]
    if value["to"] is None:
        window = window[:-1] + ")"
    sign = "less" if value["erode"] else "+"
    segments, signs = value["segments"], value["signs"]
    total = sum(count or 0 for count in signs.values())
    rows = [
        (f"{value['kind']} events", f"{value['P']} {sign} {value['Q']}, s in {window}"),
        ("form", value["form"]),
        ("edges", f"{segments['S']:,} S-edges, {segments['T']:,} T-edges"),
    ]
    if value["route"] is not None:
        rows += [("route", value["route"])]
    cut = [value[name] for name, rings in (value["cut"] or {}).items() if rings]
    if cut:
        rows += [
            ("cut along slits", f"{' and '.join(cut)}: parents are numbered along the cut rings")
        ]
    if value["pairs"] is not None:
        rows += [("pairs", f"{value['pairs']:,}; {value['filtered_pairs']:,} filtered by floats")]
    if value["kind"] == "pair":
        rows += [_meeting(value)]
    elif value["kind"] == "parallel":
        rows += [("on one line", f"{value['parallel_pairs']:,}")]
    scales = counted(value["distinct"], "scale")
    rows += [("events", f"{value['count']:,} at {scales}")]
    if value["where"] is not None:
        scales = counted(value["matching_distinct"], "scale")
        rows += [("matching", f"{value['matching']:,} at {scales}: {value['where']}")]
    if total:
        rows += [("signs", f"{total:,}: {signs['by_float'] / total:.2%} by float")]
    if value["least_precision"] is not None:
        rows += [("least precision", _least_text(value["least_precision"]))]
    rows += [("seconds", f"{value['seconds']:.3f}")]
    if value["output"]:
        rows += [("written", value["output"])]
    sys.stdout.write(lines(rows))
    if value["trial"] is not None:
        sys.stdout.write("\n" + lines(_trial_rows(value["arithmetic"], value["trial"])))
        sys.stdout.write("\n" + lines(events_in_words(value["literal"])))
        print_literal(value["literal"]["rows"][:count])
    if value["output"] is None and value["trial"] is None:
        _print_first(found, count, value["form"] == "printed")
    for warning in value["warnings"]:
        sys.stderr.write(f"warning: {escaped(warning)}\n")


def _meeting(value: dict[str, Any]) -> tuple[str, str]:
    """How many pairs meet, or are given scales by the printed interval."""
    some, always, single = (
        f"{value[name]:,}"
        for name in ("intersecting_pairs", "always_meeting_pairs", "touching_pairs")
    )
    if value["form"] == "printed":
        told = f"to {some} pairs, to {always} of them all scales; to {single} more one scale"
        return "scales given", told
    return "meeting", f"{some}, of them {always} at every scale; {single} more only touch"


def _least_text(found: dict[str, int | None]) -> str:
    if found["bits"] is not None:
        return f"{found['bits']} bits: the paper's method gets every event right"
    return f"none up to {found['most_tried']:,} bits: some events only exact arithmetic can tell"


def _trial_rows(arithmetic: str, trial: dict[str, Any]) -> list[tuple[str, str]]:
    return [
        ("the paper's method in", arithmetic),
        ("undecided pairs", f"{trial['undecided_pairs']:,} of {trial['pairs']:,}"),
        ("called inconsistent", f"{trial['false_inconsistent']:,} of {trial['roots']:,} solves"),
        ("events missed", f"{trial['missed']:,} of {trial['events']:,}"),
        ("events invented", f"{trial['invented']:,}"),
        ("off by over an ulp", f"{trial['misplaced']:,}"),
        ("in the wrong order", f"{trial['inversions']:,} pairs of events"),
        ("merged scales", f"{trial['merged']:,}"),
    ]


def _print_first(found: EventList, count: int, printed: bool) -> None:
    from rich.table import Table

    events = found.events(0, min(count, len(found)))
    if not events:
        return
    topology = events[0]["kind"] == "topology"
    table = Table("s", "about", "change", "before, after" if topology else "edges", "at")
    for event in events:
        where = ", ".join(rounded(x, 6) for x in event["at"])
        what = _features_text(event) if topology else _edges_text(event["parents"])
        change = f"{event['feature']}: {event['change']}" if topology else event["change"]
        table.add_row(event["s"], rounded(event["s"], 6), change, what, f"({where})")
    sys.stdout.write("\n")
    console().print(table)
    if len(found) > len(events):
        sys.stdout.write(f"{len(found) - len(events):,} more: --json or -o FILE gives all\n")
    if events[0]["kind"] in MEANINGS:
        sys.stdout.write(MEANINGS[events[0]["kind"]] + "\n")
    if printed:
        sys.stdout.write(AS_PRINTED + "\n")
    for name, lives in found.features().items():
        if lives:
            _print_lives(name, lives)


def _edges_text(edges: list[dict[str, Any]]) -> str:
    def place(at: list[int]) -> str:
        return f"{at[0]}.{at[1]}"

    texts = [f"{e['kind']} {place(e['edge'])} at {place(e['vertex'])}" for e in edges[:3]]
    return ", ".join([*texts, "..."] if len(edges) > 3 else texts)


def _features_text(event: dict[str, Any]) -> str:
    def names(features: list[int]) -> str:
        outside = event["feature"] == "hole"
        return ", ".join("outside" if outside and f == 0 else str(f) for f in features) or "-"

    return f"{names(event['before'])} to {names(event['after'])}"


def _print_lives(name: str, lives: list[dict[str, Any]]) -> None:
    """The scales between which each hole or component lives."""
    from rich.table import Table

    table = Table(name[:-1], "from", "to")
    for life in lives[:LIVES]:
        ends = [life["birth"], life["death"]]
        table.add_row(
            str(life["id"]),
            *(
                f"{which} of the window" if end is None else f"{end}, about {rounded(end, 6)}"
                for end, which in zip(ends, ("begin", "end"), strict=True)
            ),
        )
    sys.stdout.write("\n")
    console().print(table)
    if len(lives) > LIVES:
        sys.stdout.write(f"{len(lives) - LIVES:,} more {name}\n")
