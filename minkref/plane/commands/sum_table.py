"""The output of `minkref sum` for people."""

from __future__ import annotations

from typing import Any

from minkref.cli.output import measure, print_lines, written_row
from minkref.cli.paper_words import in_words
from minkref.plane.place import place_rows
from minkref.plane.scaling import shown_scale

SHOWN = 5  # tight passages that people see


def print_table(value: dict[str, Any]) -> None:
    rows = [
        ("sum", f"{shown_scale(value['scale'])} {value['P']} + {value['Q']}"),
        ("route, arithmetic", f"{value['route']}, {value['arithmetic']}"),
    ]
    if value["step"] is not None:
        step = value["step"]
        changes = ", ".join(
            f"{step[name]:,} {name}" for name in ("insertions", "deletions", "swaps")
        )
        rows.append((f"from {value['from']}", f"{step['groups']:,} scales of events: {changes}"))
    if value["undecided"]:
        rows.append(("result", f"undecided: {_why_undecided(value['arithmetic'])}"))
    else:
        rows += described(value)
    exact = value["exact"]
    if exact is not None:
        words = {True: "the same set", False: "another set:", None: "the true sum:"}
        rows.append(("exact", words[exact["equal"]]))
        if value["comparison"] is not None and not exact["equal"]:
            rows.append(("", in_words(value["comparison"])))
        if not exact["equal"]:
            rows += [(f"  {name}", text) for name, text in described(exact)]
    if value["remnants"] is not None:
        rows += passage_rows(value["remnants"], "polyline", "remnants")
    else:
        rows += _passage_rows(value["tight_passages"], value["readings"] is not None)
    rows += place_rows(value)
    signs = value["signs"]
    if signs is not None and signs["total"]:
        rows.append(("signs", f"{signs['total']:,}: {_deciders(signs, value['arithmetic'])}"))
    rows.append(("seconds", f"{value['seconds']:.3f}"))
    rows += written_row(value)
    print_lines(rows, value)


def _passage_rows(passages: list[dict[str, Any]] | None, as_read: bool) -> list[tuple[str, str]]:
    if as_read:
        return []
    if passages is None:
        return [("tight passages", "with --arithmetic rational only")]
    return passage_rows(passages, "polyline")


def passage_rows(
    passages: list[dict[str, Any]], long_one: str, name: str = "tight passages"
) -> list[tuple[str, str]]:
    """How many points there are and how many long ones, by this word; and the first few."""
    if not passages:
        return [(name, "none")]
    points = sum(len(passage["points"]) == 1 for passage in passages)
    counts = (_counted(points, "point"), _counted(len(passages) - points, long_one))
    rows = [(name, ", ".join(filter(None, counts)))]
    for passage in passages[:SHOWN]:
        where = " ".join(f"({x}, {y})" for x, y in passage["points"])
        rows.append(("", where if len(where) <= 200 else f"{where[:200]}..."))
    if len(passages) > SHOWN:
        rows.append(("", f"and {len(passages) - SHOWN} more; --json prints them"))
    return rows


def _counted(count: int, word: str) -> str:
    return f"{count:,} {word}{'s' if count > 1 else ''}" if count else ""


def _why_undecided(arithmetic: str) -> str:
    if arithmetic == "interval":
        return "the intervals could not certify a sign"
    return f"in the arithmetic {arithmetic} a value overflowed to what is not a number"


def _deciders(signs: dict[str, Any], arithmetic: str) -> str:
    if arithmetic != "rational":
        return f"all by {arithmetic}"
    return ", ".join(
        f"{signs['shares'][name]:.2%} {name.replace('_', ' ')}"
        for name in ("by_float", "by_integer", "by_rational")
    )


def described(value: dict[str, Any]) -> list[tuple[str, str]]:
    return [
        ("area", measure(value["area"])),
        ("components, holes", f"{value['components']}, {value['holes']}"),
        ("vertices", f"{value['vertices']:,}"),
        ("digest", value["digest"]),
    ]
