"""Events of which only the boundary at the scale tells: both sides have the same moving form."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from minkref import _core
from minkref.certify.plane.certificate import Certificate, NoProof

Triangle = list[tuple[int, int]]

# P and Q of two triangles each; the boundary events between 7/5 and 8/5 are one, at 3/2.
TURNS_ROUND = (
    ([(-1, -1), (0, -1), (0, 0)], [(1, 1), (0, 2), (0, 1)]),
    ([(0, 2), (0, 0), (1, 0)], [(-2, 1), (-3, -1), (-2, 0)]),
)
CORNERS_PASS = (
    ([(10, 0), (11, 1), (9, 1)], [(-10, 0), (-11, -1), (-9, -1)]),
    ([(-30, 0), (-29, 1), (-31, 1)], [(0, 0), (-1, -1), (1, -1)]),
)
PAIRS = pytest.mark.parametrize(
    "pair", [TURNS_ROUND, CORNERS_PASS], ids=["an edge turns round", "corners pass each other"]
)


def certificate_of(pair: tuple[tuple[Triangle, ...], ...]) -> Certificate:
    sets = (
        _core.PolygonSet.from_json(
            json.dumps({"polygons": [{"outer": triangle, "holes": []} for triangle in triangles]})
        )
        for triangles in pair
    )
    return Certificate(*sets)


@PAIRS
def test_the_event_has_a_proof_and_the_interval_has_none(
    check: Any, tmp_path: Path, pair: Any
) -> None:
    certificate = certificate_of(pair)
    with pytest.raises(NoProof, match="the boundary has an event at 3/2"):
        certificate.interval("7/5", "8/5")
    certificate = certificate_of(pair)
    certificate.event("3/2", "7/5")
    assert certificate.claims[-1]["kind"] == "boundary"
    (tmp_path / "it.case.json").write_text(certificate.case(), encoding="utf-8")
    path = tmp_path / "it.cert.json"
    path.write_text(certificate.text("it.case.json"), encoding="utf-8")
    assert check(path)[0] == 0


@PAIRS
def test_both_checkers_refute_an_interval_across_it(check: Any, tmp_path: Path, pair: Any) -> None:
    """Its steps are those of the event, one behind the other."""
    certificate = certificate_of(pair)
    certificate.event("3/2", "7/5")
    (tmp_path / "it.case.json").write_text(certificate.case(), encoding="utf-8")
    value = json.loads(certificate.text("it.case.json"))
    before, at, after = value["claims"][:3]
    assert before["digest"] == after["digest"]
    steps = [*before["steps"], at["step"], *after["steps"]]
    value["claims"] = [{**before, "to": after["to"], "steps": steps}]
    path = tmp_path / "it.cert.json"
    path.write_text(json.dumps(value), encoding="utf-8")
    code, said = check(path)
    assert code == 1
    assert "the boundary changes at" in said
