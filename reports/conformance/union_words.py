"""Unions in a report: the question, and why the witness proves its claim."""

from __future__ import annotations

import json

from minkref.fuzz.verdicts.verdict import Witness
from minkref.output.terminal import counted


def union_witness_text(witness: Witness) -> str:
    """One sentence, to be checked by hand."""
    point = f"({', '.join(witness.point)})"
    around = (
        f" with all points that differ by at most {witness.tolerance} in each coordinate"
        if witness.tolerance != "0"
        else ""
    )
    if witness.in_truth:
        return f"witness {point} is in the union{around}: in set {witness.of_set}"
    return f"witness {point} is outside the union{around}: in none of {_sets(witness)}"


def union_argument(witness: Witness) -> list[str]:
    return [union_witness_text(witness).removeprefix("witness ").capitalize() + "."]


def named_sets(literal: str) -> list[tuple[str, str]]:
    """Each set's name, and its JSON text."""
    sets = json.loads(literal)["sets"]
    return [(f"set {k + 1}", json.dumps(each)) for k, each in enumerate(sets)]


def union_question(literal: str) -> list[str]:
    """A case's lines besides its sets."""
    return [f"the union of {counted(len(named_sets(literal)), 'set')}"]


def _sets(witness: Witness) -> str:
    return counted(witness.sets or 0, "set")
