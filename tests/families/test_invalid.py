"""Invalid pairs: one operand is refused for the named reason."""

from __future__ import annotations

import pytest
from minkref import _core
from minkref.fuzz.invalid.family import KINDS, invalid_pair

SEED = 13
CODES = {
    "self-intersecting": {"self-intersection"},
    "overlapping-rings": {"crossing-rings"},
    "crossing-polygons": {"crossing-rings"},
    "hole-outside": {"hole-outside"},
    "nested-twice": {"overlapping-rings"},
    "repeated-vertex": {"zero-length-edge"},
    "spike": {"self-intersection"},
    "zero-area": {"zero-area"},
    "too-few-vertices": {"too-few-vertices"},
    "ring-twice": {"overlapping-rings"},
}


def refusal(text: str) -> str | None:
    try:
        _core.PolygonSet.from_json(text).validate("operand")
    except _core.BadInput as error:
        return error.code
    return None


def test_one_operand_is_refused_and_the_other_is_not() -> None:
    for index in range(20 * len(KINDS)):
        kind, P, Q = invalid_pair(SEED, index)
        codes = [refusal(P), refusal(Q)]
        wrong = index // len(KINDS) % 2
        assert codes[1 - wrong] is None, f"invalid:{SEED}:{index}"
        assert codes[wrong] in CODES[kind], f"invalid:{SEED}:{index}"


def test_a_pair_depends_on_seed_and_index_only() -> None:
    assert invalid_pair(SEED, 17) == invalid_pair(SEED, 17) != invalid_pair(SEED + 1, 17)


@pytest.mark.parametrize("kind", KINDS)
def test_every_kind_has_many_forms(kind: str) -> None:
    first = KINDS.index(kind)
    texts = {invalid_pair(SEED, first + len(KINDS) * k)[1:] for k in range(20)}
    assert len(texts) == 20
