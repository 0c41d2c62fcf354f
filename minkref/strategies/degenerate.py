"""Members of the degenerate families."""

from __future__ import annotations

from collections.abc import Callable

from hypothesis import strategies as st
from minkref.degeneracies.catalogue import FAMILIES
from minkref.degeneracies.family import FEWEST, MOST, NothingDrawn
from minkref.degeneracies.plane.draft import Draft, Facts, Family
from minkref.errors import nearest
from minkref.fuzz.geometry.plane import doubled_area
from minkref.strategies.dice import Dice
from minkref.strategies.reduction import KINDS, places, simpler, without
from minkref.strategies.values import DegeneratePair, data_of

DEGENERATE_FAMILIES = tuple(FAMILIES)
SELDOM = st.integers(0, 99)
PRICE = 3  # draws for a step not taken: Hypothesis finds fewer draws simpler


def degenerate_pairs(family: str | None = None) -> st.SearchStrategy[DegeneratePair]:
    """Draw members of one of DEGENERATE_FAMILIES, or of any: operands P, Q, and the scale at which
    scale P + Q is degenerate.

    Shrinks by the throws of the family's generator, which Hypothesis draws, and by steps that drop
    polygons, holes and vertices and simplify numbers, each only if the result is a member. Exact,
    and always valid. 5 to 50 ms per member. Raises ValueError for an unknown name."""
    if family is None:
        return st.sampled_from(list(FAMILIES.values())).flatmap(_members)
    if family not in FAMILIES:
        near = nearest(family, FAMILIES) or f"the families are {', '.join(FAMILIES)}"
        raise ValueError(f"there is no family {family!r}: {near.strip()}")
    return _members(FAMILIES[family])


def _members(family: Family) -> st.SearchStrategy[DegeneratePair]:
    return _reduced(family).map(
        lambda draft: {
            "family": family.name,
            "P": data_of(draft.P),
            "Q": data_of(draft.Q),
            "scale": str(draft.scale),
        }
    )


@st.composite
def _candidates(draw: st.DrawFn, family: Family) -> Draft | None:
    """Draw a draft; None also if a ring needs turning, which would change vertex numbers used by
    the predicates."""
    try:
        draft = family.draw(Dice(draw), draw(st.integers(FEWEST, MOST)))
    except NothingDrawn:
        return None
    turned = any(doubled_area(polygon[0]) < 0 for shape in (draft.P, draft.Q) for polygon in shape)
    return None if turned and draft.zeros else draft


@st.composite
def _taken(draw: st.DrawFn) -> bool:
    """Draw True seldom while Hypothesis generates; shrinks to True."""
    if draw(SELDOM) == 0:
        return True
    for _ in range(PRICE):
        draw(SELDOM)
    return False


@st.composite
def _reduced(draw: st.DrawFn, family: Family) -> Draft:
    """Draw every step, so that Hypothesis keeps the steps that preserve its finding."""
    drawn = draw(_candidates(family).filter(lambda draft: draft and is_member(family, draft)))
    assert drawn is not None
    draft: Draft = drawn

    def take(change: Callable[[Draft], Draft | None]) -> None:
        nonlocal draft
        if draw(_taken()):
            changed = change(draft)
            if changed and changed != draft and is_member(family, changed):
                draft = changed

    for kind in KINDS:
        for name, place in places(draft, kind):
            take(lambda d: without(d, name, place))  # noqa: B023 called at once
    for change in simpler():
        take(change)
    return draft


def is_member(family: Family, draft: Draft) -> bool:
    """Tell whether a draft is a member, and whether all claimed zeros are zero."""
    facts = Facts.of_valid(draft)
    return (
        facts is not None
        and all(facts.vertices.value(zero, facts.scale) == 0 for zero in draft.zeros)
        and family.belongs(facts)
    )
