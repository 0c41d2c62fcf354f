"""Paths in a report: the question, and why the witness proves its claim."""

from __future__ import annotations

import json

from minkref.fuzz.verdicts.verdict import Witness

WHAT = {
    "allowed": "in the interior of the part and in that of the obstacles",
    "forbidden": "in the part and in the obstacles",
}


def path_witness_text(witness: Witness) -> str:
    """One sentence, to be checked by hand."""
    what = WHAT[witness.contact or ""]
    around = ""
    if witness.tolerance != "0":
        size = "smaller" if witness.in_truth else "larger"
        around = f", also with obstacles that are {size} by {witness.tolerance} on all sides"
    if witness.in_truth and witness.p and witness.q and witness.on_path:
        segment, t = witness.on_path
        x, p, q = (f"({', '.join(numbers)})" for numbers in (witness.point, witness.p, witness.q))
        return (
            f"witness: at the scale {witness.scale} the part collides at {x}, segment {segment} of "
            f"the path, t = {t}: {x} + {witness.scale} * {p} = {q}, {what}{around}"
        )
    return (
        f"witness: at the scale {witness.scale} the part passes: at none of {witness.places:,} "
        "places, those where it starts or stops to touch and one between any two, is there a point "
        f"{what}{around}"
    )


def path_argument(witness: Witness) -> list[str]:
    """Sentences that can be checked with paper and pencil."""
    if not (witness.in_truth and witness.p and witness.q):
        return [path_witness_text(witness).removeprefix("witness: ").capitalize() + "."]
    sums = "; ".join(
        f"{name}: {x} + {witness.scale} * {_signed(p)} = {q}"
        for name, x, p, q in zip("xy", witness.point, witness.p, witness.q, strict=True)
    )
    return [path_witness_text(witness).removeprefix("witness: ").capitalize() + ".", sums + "."]


def _signed(number: str) -> str:
    return f"({number})" if number.startswith("-") else number


def path_question(literal: str) -> list[str]:
    """A case's lines besides its operands."""
    value = json.loads(literal)
    path = " ".join(f"({x}, {y})" for x, y in value["path"])
    scales = (
        ", ".join(value["scales"]) if "scales" in value else f"{value['from']} to {value['to']}"
    )
    return [f"path: {path}", f"contact: {value['contact']}", f"scales: {scales}"]
