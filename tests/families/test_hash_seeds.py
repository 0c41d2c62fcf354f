"""Members depend on seed and number only: two processes, which hash otherwise and take families and
numbers in another order, make what this one makes."""

from __future__ import annotations

import pytest
from members import GROUPS, SEED, digest_of, digests
from thoroughness import some


@pytest.mark.parametrize("group", GROUPS)
def test_members_depend_on_seed_and_number_only(group: str) -> None:
    _, names, *_ = GROUPS[group]
    told = digests()[group]
    assert sorted(told) == sorted(names)
    for name in some(names, 1):
        assert digest_of(group, name) == told[name]
    assert digest_of(group, names[0]) != digest_of(group, names[0], SEED + 1)
