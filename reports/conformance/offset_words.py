"""Sets grown by a disc in a report: the question, and why the witness proves its claim."""

from __future__ import annotations

import json

from minkref.fuzz.verdicts.verdict import Witness


def offset_witness_text(witness: Witness) -> str:
    """One sentence, to be checked by hand."""
    point = f"({', '.join(witness.point)})"
    if witness.squared_distance is None:
        return f"witness {point} is outside: the empty set grows to nothing"
    side = "is in the set grown" if witness.in_truth else "is outside the set grown"
    return f"witness {point} {side} by {_radius(witness)}: {_nearest(witness)}"


def offset_argument(witness: Witness) -> list[str]:
    """The witness, and the numbers to compare."""
    sentences = [offset_witness_text(witness).removeprefix("witness ") + "."]
    if witness.squared_distance is None:
        return sentences
    sign, word = ("-", "at most") if witness.in_truth else ("+", "more than")
    bound = f"({witness.radius} {sign} {witness.tolerance})²"
    if witness.tolerance == "0":
        bound = f"{witness.radius}²"
    return [*sentences, f"Its squared distance, {witness.squared_distance}, is {word} {bound}."]


def offset_question(literal: str) -> list[str]:
    """A case's lines besides its set."""
    return [f"the set grown by a disc of radius {json.loads(literal)['radius']}"]


def offset_set(literal: str) -> str:
    """The set's JSON text."""
    return json.dumps(json.loads(literal)["offset"])


def _radius(witness: Witness) -> str:
    if witness.tolerance == "0":
        return str(witness.radius)
    return f"{witness.radius}, give or take {witness.tolerance}"


def _nearest(witness: Witness) -> str:
    nearest = witness.nearest or ("inside",)
    if nearest[0] == "inside":
        return "the set has it"
    far = f"its squared distance from the set is {witness.squared_distance}"
    if nearest[0] == "vertex":
        return f"{far}, to the vertex ({', '.join(nearest[1:])})"
    ends = f"({', '.join(nearest[1:3])}) to ({', '.join(nearest[3:])})"
    return f"{far}, to the edge from {ends}"
