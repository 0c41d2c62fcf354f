"""The paper's way to events of facets, by the code, on all pairs of facets of two polyhedra."""

from __future__ import annotations

from minkref import _core


def contacts_as_read(P: _core.Polyhedron, Q: _core.Polyhedron, **readings: str) -> dict[str, int]:
    """Count what the sentences as read miss and invent, all others corrected, in rational
    numbers."""
    corrected = {name: right for name, _, right, _ in _core.facet_readings()}
    return dict(_core.facet_contact_trial(P, Q, "rational", corrected | readings))
