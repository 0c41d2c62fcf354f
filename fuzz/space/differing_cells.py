"""How a claimed set of cells differs from the true set, in a verdict's words."""

from __future__ import annotations

from collections.abc import Iterable

from minkref.fuzz.space.cells import Cell, Cells, cavities, parts
from minkref.fuzz.verdicts.verdict import Reason


def cell_reasons(truth: Cells, claim: Cells, found: Iterable[Reason]) -> list[Reason]:
    """Names lost and invented cavities and components; omits MISSING and EXTRA in `found` if these
    explain the whole difference."""
    surplus, absent = set(claim) - set(truth), set(truth) - set(claim)
    reasons: list[Reason] = []
    if Reason.EXTRA in found:
        filled = [part for part in cavities(truth) if part <= surplus]
        invented = [part for part in parts(claim) if part <= surplus]
        reasons += _named(
            surplus, (Reason.HOLE_LOST, filled), (Reason.COMPONENT, invented), Reason.EXTRA
        )
    if Reason.MISSING in found:
        hollow = [part for part in cavities(claim) if part <= absent]
        lost = [part for part in parts(truth) if part <= absent]
        reasons += _named(
            absent, (Reason.HOLE_INVENTED, hollow), (Reason.COMPONENT, lost), Reason.MISSING
        )
    return list(dict.fromkeys(reasons))


def _named(
    difference: set[Cell],
    first: tuple[Reason, list[set[Cell]]],
    second: tuple[Reason, list[set[Cell]]],
    rest: Reason,
) -> list[Reason]:
    names: list[Reason] = []
    left = set(difference)
    for reason, sets in (first, second):
        if sets:
            names.append(reason)
            left.difference_update(*sets)
    return [*names, rest] if left else names
