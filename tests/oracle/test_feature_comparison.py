"""The reference's features are those of the judge, on sets of all kinds; and the comparison refuses
answers with a single error."""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Callable
from typing import Any

import pytest
from minkref import _core
from minkref.fuzz.features.feature_comparison import feature_faults
from minkref.fuzz.features.feature_draws import KINDS, drawn_set, set_of
from minkref.fuzz.judges.disc.cut_comparison import cut_faults
from minkref.oracle.features import Judge
from thoroughness import draws

SEED, SETS = 83, draws(20, 400)
Change = Callable[[Any], Any]


class Altered:
    """Features with one answer changed."""

    def __init__(self, found: _core.Features, method: str, change: Change) -> None:
        self._found, self._method, self._change = found, method, change

    def __getattr__(self, name: str) -> Any:
        value = getattr(self._found, name)
        if name != self._method:
            return value
        return lambda *given: self._change(value(*given))


def without_first(rows: list[Any]) -> list[Any]:
    return rows[1:]


def with_field(k: int, change: Change) -> Change:
    """Changes a field of the last row."""

    def changed(rows: list[Any]) -> list[Any]:
        if not rows:
            return rows
        row = list(rows[-1])
        row[k] = change(row[k])
        return [*rows[:-1], tuple(row)]

    return changed


ERRORS: dict[str, tuple[str, Change]] = {
    "a bar less": ("bars", without_first),
    "another death": ("bars", with_field(2, lambda death: 1 if death is None else None)),
    "essential or not": ("bars", with_field(4, lambda is_essential: not is_essential)),
    "a tie": ("nodes", with_field(6, lambda tie: not tie)),
    "a radius": ("radius_rows", with_field(3, lambda bounds: (bounds[1] * 1.1, bounds[1] * 1.2))),
    "a polynomial": ("radius_rows", with_field(2, lambda factors: ["1", *factors])),
    "a track less": ("tracks", without_first),
    "a feature less": ("at", without_first),
    "a bridge less": ("at", with_field(4, lambda bridges: bridges[1:])),
    "leaves": ("at", with_field(2, lambda leaves: [*leaves, 0])),
    "a notch less": ("notches", without_first),
    "notches in reverse": ("notches", lambda rows: rows[::-1]),
    "a tree": ("canonical_json", lambda text: text.replace('"reflex"', '"minimum"')),
}


def test_features_are_those_of_the_judge() -> None:
    print(f"seed {SEED}")
    dice = random.Random(SEED)
    counts: Counter[str] = Counter()
    for number in range(SETS):
        name, shape = drawn_set(SEED, number)
        found = _core.features(set_of(shape))
        assert feature_faults(Judge(shape), found, dice, counts) == [], name
    assert counts["bridges"] > SETS and counts["notches"] > SETS
    assert SETS % len(KINDS) == 0


def test_cuts_and_pieces_are_those_of_the_judge() -> None:
    print(f"seed {SEED}")
    dice = random.Random(SEED)
    counts: Counter[str] = Counter()
    for number in range(SETS):
        name, shape = drawn_set(SEED, number)
        assert cut_faults(shape, Judge(shape), set_of(shape), dice, counts) == [], name
    assert counts["cuts"] > SETS and counts["pieces"] > SETS


@pytest.mark.parametrize("error", ERRORS)
def test_a_single_error_is_refused(error: str) -> None:
    print(f"seed {SEED}")
    method, change = ERRORS[error]
    for number in range(2 * len(KINDS)):
        _, shape = drawn_set(SEED, number)
        found: Any = Altered(_core.features(set_of(shape)), method, change)
        if feature_faults(Judge(shape), found, random.Random(number), Counter()):
            return
    pytest.fail("the judge accepts it in all sets")
