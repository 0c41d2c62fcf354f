"""Families whose boundary changes at a scale, with the same figure below and above: each recognises
its published case and takes no other."""

from __future__ import annotations

import pytest
from minkref.degeneracies.catalogue import FAMILIES
from minkref.degeneracies.found import FOUND
from minkref.degeneracies.plane.touches import FAMILIES as TOUCHES

STORIES = {
    "an edge that turns round in a point": "side-turns-round",
    "corners that pass each other": "corners-pass",
    "a corner that goes straight on": None,
}
SEED = 5


@pytest.mark.parametrize("title", STORIES)
def test_a_story_belongs_to_its_family_alone(title: str) -> None:
    (story,) = (story for story in FOUND if story.title == title)
    belongs = [family.name for family in TOUCHES if family.belongs(story.facts)]
    assert belongs == [name for name in (STORIES[title],) if name]


@pytest.mark.parametrize("family", [family.name for family in TOUCHES])
def test_a_member_belongs_to_one_of_the_families(family: str) -> None:
    facts = FAMILIES[family].member(SEED, 0)[0]
    assert [other.name for other in TOUCHES if other.belongs(facts)] == [family]


def test_numbers_below_and_above_tell_nothing() -> None:
    """Compares the counts of holes, components and, except for one family, vertices."""
    for family in TOUCHES:
        facts = family.member(SEED, 1)[0]
        below, _, above = facts.counts
        assert below == above and facts.boundary
        if family.name != "one-hole-for-another":
            assert facts.beside[0].region.vertices == facts.beside[1].region.vertices
