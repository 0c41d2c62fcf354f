"""The answers of the paper's own program in words."""

from __future__ import annotations

from typing import Any

from minkref.exact import rounded
from minkref.output.terminal import console


def in_words(found: dict[str, Any]) -> str:
    """A comparison in words."""
    if found["same_structure"]:
        off = found["ulps"]
        return "the same set" if off == 0 else f"the same structure, up to {off:.3g} ulp off"
    witness = found["witness"]
    if witness is None:
        return "another structure"
    x, y = witness["point"]
    where = "in the sum, and lost" if witness["in_sum"] else "not in the sum, and added"
    return f"another structure: ({x}, {y}) is {where}"


def events_in_words(events: dict[str, Any]) -> list[tuple[str, str]]:
    """Rows of what people read of the events."""
    rows = [
        (
            "events",
            f"{events['right']:,} right, {events['misplaced']:,} at another scale, "
            f"{events['missed']:,} missed, {events['invented']:,} invented",
        )
    ]
    for what in ("missed", "invented"):
        event = events.get(f"first_{what}")
        if event is not None:
            scale = rounded(event["scale"])
            told = f"at {scale}, {event['change']}: {event['a']} and {event['b']}"
            rows.append((f"first {what}", told))
    return rows


def print_literal(rows: list[dict[str, Any]]) -> None:
    """A table of events of the program, with the exact scales."""
    from rich.table import Table

    if not rows:
        return
    table = Table(box=None, pad_edge=False)
    for heading in ("its scale", "exact", "change", "edges"):
        table.add_column(heading, no_wrap=True)
    for row in rows:
        exact = row["exact"]
        table.add_row(
            rounded(row["scale"], 17),
            "invented" if exact is None else rounded(exact, 17),
            row["change"],
            f"{row['a']}, {row['b']}",
        )
    console().print(table)
