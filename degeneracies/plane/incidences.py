"""Vertices and edges of the convolution that meet without need."""

from __future__ import annotations

from random import Random

from minkref.degeneracies.plane.draft import Draft, Facts, Family
from minkref.degeneracies.plane.flags import three_lines_meet
from minkref.degeneracies.plane.mining import (
    convex_pair,
    ends_at,
    mined,
    overlap_is_whole,
    small_pair,
    upright_pair,
)


def _is_vertex_on_edge(facts: Facts) -> bool:
    return any(
        sorted(ends_at(facts, row)) == [0, 1] for row in facts.arrangement if row["kind"] == "pair"
    )


def _is_vertices_meeting(facts: Facts) -> bool:
    return any(min(ends_at(facts, row)) == 1 for row in facts.arrangement if row["kind"] == "pair")


def _overlaps(facts: Facts, whole: bool) -> bool:
    return any(
        overlap_is_whole(facts, row) == whole
        for row in facts.arrangement
        if row["kind"] == "parallel" and row["to"] is not None
    )


def _is_partly(facts: Facts) -> bool:
    return _overlaps(facts, False)


def _is_wholly(facts: Facts) -> bool:
    return _overlaps(facts, True)


def _is_several(facts: Facts) -> bool:
    return len({row["at"] for row in facts.arrangement}) >= 3


def _is_concurrent(facts: Facts) -> bool:
    """Whether three edges, no two parallel, pass through a place that is no end of theirs, and
    where no two edges start or stop meeting."""
    others = {row["at"] for row in facts.arrangement if row["kind"] != "triple"}
    return any(
        row["kind"] == "triple"
        and row["at"] not in others
        and three_lines_meet(facts, row)
        and not any(ends_at(facts, row))
        for row in facts.arrangement
    )


def _concurrent(dice: Random, size: int) -> Draft:
    return mined(dice, small_pair, _is_concurrent)


def _vertex_on_edge(dice: Random, size: int) -> Draft:
    return mined(dice, small_pair, _is_vertex_on_edge)


def _vertices_meet(dice: Random, size: int) -> Draft:
    return mined(dice, upright_pair, _is_vertices_meeting)


def _partly(dice: Random, size: int) -> Draft:
    return mined(dice, upright_pair, _is_partly)


def _wholly(dice: Random, size: int) -> Draft:
    return mined(dice, upright_pair, _is_wholly)


def _several(dice: Random, size: int) -> Draft:
    return mined(
        dice, lambda dice: dice.choice((small_pair, convex_pair, upright_pair))(dice), _is_several
    )


FAMILIES = (
    Family(
        "concurrent-edges",
        "three edges of the convolution through one point at one scale",
        _concurrent,
        _is_concurrent,
    ),
    Family(
        "vertex-on-edge",
        "a vertex of the convolution on another edge at one scale",
        _vertex_on_edge,
        _is_vertex_on_edge,
    ),
    Family(
        "vertices-meet",
        "two vertices of the convolution in one place at one scale",
        _vertices_meet,
        _is_vertices_meeting,
    ),
    Family(
        "coincident-partly",
        "edges of the convolution that share a segment, no edge wholly, at one scale",
        _partly,
        _is_partly,
    ),
    Family(
        "coincident-wholly",
        "edges of the convolution of which one lies on another, at one scale",
        _wholly,
        _is_wholly,
    ),
    Family("several-events", "events in three or more places at one scale", _several, _is_several),
)
