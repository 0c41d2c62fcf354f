"""Sets grown or eroded by a disc in a report: the question, and why the witness proves its
claim."""

from __future__ import annotations

import json

from minkref.fuzz.offsets.lines import read_lines
from minkref.fuzz.offsets.manner import read_manner
from minkref.fuzz.verdicts.verdict import Witness


def offset_witness_text(witness: Witness) -> str:
    """One sentence, to be checked by hand."""
    point = f"({', '.join(witness.point)})"
    if witness.squared_distance is None:
        return f"witness {point} is outside: the empty set grows to nothing"
    what = "the set eroded" if is_inward(str(witness.radius)) else "the set grown"
    side = "in" if witness.in_truth else "outside"
    return f"witness {point} is {side} {what} by {_radius(witness)}: {_nearest(witness)}"


def is_inward(radius: str) -> bool:
    """Whether a disc of this radius erodes."""
    return radius.startswith("-")


def offset_argument(witness: Witness) -> list[str]:
    """The witness, and the numbers to compare."""
    sentences = [offset_witness_text(witness).removeprefix("witness ") + "."]
    if witness.squared_distance is None:
        return sentences
    if witness.manner is not None:
        return sentences
    inward, radius = is_inward(str(witness.radius)), str(witness.radius).removeprefix("-")
    sign, word = ("-", "at most") if witness.in_truth else ("+", "more than")
    if inward:
        sign, word = ("+", "at least") if witness.in_truth else ("-", "less than")
    bound = f"({radius} {sign} {witness.tolerance})²"
    if witness.tolerance == "0":
        bound = f"{radius}²"
    return [*sentences, f"Its squared distance, {witness.squared_distance}, is {word} {bound}."]


def offset_question(literal: str) -> list[str]:
    """A case's lines besides its set."""
    value = json.loads(literal)
    radius = str(value["radius"])
    done = "eroded" if is_inward(radius) else "grown"
    what = "lines" if "lines" in value["offset"] else "set"
    manner = read_manner(value, what == "lines", "the case")
    end = "" if manner.is_round else f", with {manner}"
    return [f"the {what} {done} by a disc of radius {radius.removeprefix('-')}{end}"]


def offset_set(literal: str) -> str:
    """The JSON text of the set, or of the lines' segments."""
    given = json.loads(literal)["offset"]
    if "lines" in given:
        return str(read_lines(given["lines"], "the case")[1].to_json())
    return json.dumps(given)


def _radius(witness: Witness) -> str:
    radius = str(witness.radius).removeprefix("-")
    if witness.manner is not None:
        radius += f" with {witness.manner}"
    return radius if witness.tolerance == "0" else f"{radius}, give or take {witness.tolerance}"


def _nearest(witness: Witness) -> str:
    nearest = witness.nearest or ("inside",)
    if nearest[0] == "inside":
        return "the set has it"
    if nearest[0] == "outside":
        return "the set does not have it"
    of = "outside" if is_inward(str(witness.radius)) else "set"
    far = f"its squared distance from the {of} is {witness.squared_distance}"
    if nearest[0] == "vertex":
        return f"{far}, to the vertex ({', '.join(nearest[1:])})"
    ends = f"({', '.join(nearest[1:3])}) to ({', '.join(nearest[3:])})"
    return f"{far}, to the edge from {ends}"
