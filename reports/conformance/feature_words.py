"""Concave features in reports: question, witness in words."""

from __future__ import annotations

import json
from fractions import Fraction
from typing import Any

from minkref.fuzz.verdicts.feature_claim import FeatureClaim
from minkref.fuzz.verdicts.verdict import Witness

SHOWN = 200  # bars or bridges of an answer


def feature_witness_text(witness: Witness) -> str:
    """One sentence."""
    claim = witness.feature
    assert claim is not None
    if claim.kind == "set":
        return "witness: the set is valid"
    if claim.kind == "shape":
        return f"witness: the alpha-shape has {claim.in_set} {claim.what}, not {claim.in_answer}"
    if claim.kind == "bridge":
        return f"witness {_near(witness.point)}: {_bridge(claim)}"
    has = _times(claim.in_set)
    text = f"the set has {has} bar {claim.what}, the answer {_times(claim.in_answer)}"
    if claim.ends_at and claim.in_set > claim.in_answer:
        text += f"; it ends at {_near(claim.ends_at)}"
    if claim.nearest is not None:
        text += f"; the set's nearest one goes {claim.nearest}"
    return f"witness {_near(witness.point)}: {text}"


def feature_argument(witness: Witness) -> list[str]:
    """The witness, and what to compare."""
    claim = witness.feature
    assert claim is not None
    sentences = [feature_witness_text(witness).removeprefix("witness ").removeprefix(": ") + "."]
    if claim.kind == "bar":
        sentences += [
            f"{word}: the nearest points of the set are as far from {_near(place)} as the radius."
            for word, place in (("Birth", claim.begins_at), ("Death", claim.ends_at))
            if place is not None
        ]
    return [*sentences, "Two judges that share nothing find the same features."]


def feature_question(literal: str) -> list[str]:
    """A case's lines besides its set."""
    radius = json.loads(literal)["radius"]
    return [f"bars of its concave features; bridges of a disc of radius {radius}"]


def features_set(literal: str) -> str:
    """The set's JSON text."""
    return json.dumps(json.loads(literal)["features"])


def features_lines(value: dict[str, Any]) -> list[str]:
    """Lines for bars, bridges, counts."""
    bars = [f"bar from {_radius(birth)} to {_radius(death)}" for birth, death in value["bars"]]
    chords = [f"bridge {_near(a)} to {_near(b)}" for a, b in value.get("bridges", [])]
    counts = [f"{value[word]} {word}" for word in ("components", "holes") if word in value]
    return [*bars[:SHOWN], *chords[:SHOWN], *counts]


def _bridge(claim: FeatureClaim) -> str:
    if claim.in_set > claim.in_answer:
        return f"the disc about it touches the set at both ends of the bridge {claim.what}"
    has = "none" if not claim.in_set else str(claim.in_set)
    return f"the answer has a bridge {claim.what}, the set {has} there"


def _radius(value: Any) -> str:
    if value is None:
        return "infinity"
    if isinstance(value, dict):
        return f"sqrt({value['square']})"
    return f"about {float(Fraction(value[0]))!r}" if isinstance(value, list) else str(value)


def _near(place: Any) -> str:
    return f"({', '.join(f'{float(Fraction(x)):.12g}' for x in place)})"


def _times(count: int) -> str:
    return "no" if count == 0 else str(count)
