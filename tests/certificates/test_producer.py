"""Certificates of the producer are verified by both checkers; changed certificates are not."""

from __future__ import annotations

import json
import random
from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from minkref import _core
from minkref.certify.plane.certificate import Certificate, NoProof
from minkref.exact import digest
from minkref.fuzz.judges.plane.certified_claims import Confirmation
from minkref.fuzz.plane.families.catalogue import FAMILIES
from minkref.reports.evidence.certificates.mutants import mutants
from named_cases import named
from thoroughness import draws

SEED = 7


def written(certificate: Certificate, folder: Path) -> Path:
    (folder / "it.case.json").write_text(certificate.case(), encoding="utf-8")
    path = folder / "it.cert.json"
    path.write_text(certificate.text("it.case.json", "a test"), encoding="utf-8")
    return path


@pytest.mark.parametrize("family", FAMILIES)
def test_sums_and_their_tight_passages(check: Any, tmp_path: Path, family: str) -> None:
    for index in range(draws(1, 3)):
        case = named(f"{family}:{SEED}:{index}")
        if not any(o.is_region or o.is_empty for o in (case.P, case.Q)):
            continue
        certificate = Certificate(case.P, case.Q)
        certificate.sum(case.scale, passages=True)
        code, said = check(written(certificate, tmp_path))
        assert code == 0, (case.name.text, said)
        found = _core.minkowski_sum(case.P, case.Q, case.scale, tight_passages=True)
        assert digest(found.region.canonical_json()) in said
        assert len(certificate.claims) == 1 + len(found.tight_passages)


# In sums of large coordinates of both signs, the box of a piece times a scale that is no double.
@pytest.mark.parametrize("flip", ["1", "-1"])
def test_triangles_far_out_on_both_sides(check: Any, tmp_path: Path, flip: str) -> None:
    unit = _core.PolygonSet.from_json('{"polygons":[{"outer":[[0,0],[1,0],[0,1]]}]}')
    x = int(flip) * 10**17
    certificate = Certificate(unit.translated(str(-x), "0"), unit.translated(str(x), "0"))
    for scale in ("29/28", "28/29", "1/3", "3"):
        certificate.sum(scale)
    code, said = check(written(certificate, tmp_path))
    assert code == 0, said


@pytest.mark.parametrize("family", ["random", "holes", "nested", "comb", "touching", "spiral"])
def test_events(check: Any, tmp_path: Path, family: str) -> None:
    case = named(f"{family}:{SEED}:2")
    dynamic = _core.DynamicSum(case.P, case.Q)
    scales = sorted({Fraction(row[0]) for row in dynamic.boundary_events()})
    for i, scale in enumerate(scales[: draws(1, 2)]):
        certificate = Certificate(case.P, case.Q)
        certificate.event(scale, scales[i - 1] if i else scale / 2)
        code, said = check(written(certificate, tmp_path))
        assert code == 0, (case.name.text, str(scale), said)


def triangle_in_frame() -> tuple[_core.PolygonSet, _core.PolygonSet]:
    texts = (
        "POLYGON((-3 -2, 4 -1, 1 3, -3 -2))",
        "POLYGON((-40 -40, 40 -40, 40 40, -40 40, -40 -40), (0 20, 17 -11, -19 -9, 0 20))",
    )
    P, Q = (_core.read_text(text, "wkt", "test") for text in texts)
    return P, Q


@pytest.mark.parametrize("family", ["random", "holes", "touching", "fit"])
def test_all_events_of_a_window(check: Any, tmp_path: Path, family: str) -> None:
    """Those that the timeline lists, from one event to another: both ends are left out."""
    case = named(f"{family}:{SEED}:2")
    rows = _core.DynamicSum(case.P, case.Q, "1/2", "4").boundary_events()
    scales = sorted({Fraction(row[0]) for row in rows})[: draws(4, 12)]
    certificate = Certificate(case.P, case.Q)
    if len(scales) < 2:
        scales = [Fraction(1, 2), *scales, Fraction(4)]
    certificate.events(scales[0], scales[-1])
    assert certificate.claims[-1]["scales"] == [str(s) for s in scales[1:-1]]
    code, said = check(written(certificate, tmp_path))
    assert code == 0, (case.name.text, said)


def test_the_death_of_a_hole(check: Any, tmp_path: Path) -> None:
    certificate = Certificate(*triangle_in_frame())
    certificate.event("541/186", 1)
    assert certificate.claims[-1]["kind"] == "topology"
    code, said = check(written(certificate, tmp_path))
    assert code == 0, said
    holes = [claim["holes"] for claim in certificate.claims if "holes" in claim]
    assert holes == [1, 0, 0]


@pytest.mark.parametrize("family", ["random", "holes", "comb", "touching", "degenerate", "fit"])
def test_degeneracies(check: Any, tmp_path: Path, family: str) -> None:
    """Proves each of the first critical scales critical: a zero there, and the signs beside."""
    case = named(f"{family}:{SEED}:2")
    events = _core.ArrangementEvents(case.P, case.Q)
    rows = events.rows(events.of_kind("arrangement"))
    for scale in list(dict.fromkeys(row[0] for row in rows))[:5]:
        certificate = Certificate(case.P, case.Q)
        certificate.degeneracy(scale)
        zeros = [claim for claim in certificate.claims if claim["sign"] == 0]
        assert any(claim["from"] == claim["to"] == scale for claim in zeros)
        code, said = check(written(certificate, tmp_path))
        assert code == 0, (case.name.text, scale, said)


def test_three_edges_in_one_point(check: Any, tmp_path: Path) -> None:
    certificate = Certificate(*triangle_in_frame())
    certificate.degeneracy("541/186")
    assert [claim["sign"] for claim in certificate.claims] in ([-1, 0, 1], [1, 0, -1])
    assert {claim["of"][0] for claim in certificate.claims} == {"concurrent"}
    code, said = check(written(certificate, tmp_path))
    assert code == 0, said


def test_points_of_the_sum(check: Any, tmp_path: Path) -> None:
    certificate = Certificate(*triangle_in_frame())
    corner = json.loads(certificate.case())["Q"]["polygons"][0]["outer"][0]
    certificate.point(2, (str(2 * -3 + int(corner[0])), str(2 * -2 + int(corner[1]))))
    certificate.point("7/3", ("45", "1/3"))
    code, said = check(written(certificate, tmp_path))
    assert code == 0, said
    with pytest.raises(NoProof, match="not in the sum"):
        certificate.point(1, ("0", "0"))
    with pytest.raises(NoProof, match="is in the sum"):
        certificate.outside(1, (43, 0))


def test_the_only_event_of_a_window(check: Any, tmp_path: Path) -> None:
    certificate = Certificate(*triangle_in_frame())
    certificate.events("5/2", "3")
    claim = certificate.claims[-1]
    told = {name: claim[name] for name in ("scales", "kinds", "components", "holes")}
    assert told == {
        "scales": ["541/186"], "kinds": ["topology"], "components": [1, 1], "holes": [1, 0],
    }  # fmt: skip
    assert Confirmation(certificate.case()).all_hold(certificate.claims)
    code, said = check(written(certificate, tmp_path))
    assert code == 0 and "without both, all of the boundary: topology at 541/186" in said, said


def changed_windows(claims: list[Any]) -> Iterator[tuple[str, Any]]:
    """Another value for each member of a claim of all events: a list loses or repeats an entry."""
    claim = claims[-1]
    for name, value in claim.items():
        if name in ("from", "to"):
            yield from ((name, other) for other in ("1/3", "11/4", "7", claims[1]["scale"]))
        elif name != "claim":
            others = [value[:-1], [*value, value[-1]], value[::-1], [], 0]
            others += [[other, *value[1:]] for other in (0, 1, 2, "boundary", "5/2")]
            yield from ((name, other) for other in others if other != value)


def test_other_lists_of_events_are_refused(check: Any, tmp_path: Path) -> None:
    certificate = Certificate(*triangle_in_frame())
    certificate.events("5/2", "3")
    path = written(certificate, tmp_path)
    value = json.loads(path.read_text(encoding="utf-8"))
    for name, other in changed_windows(value["claims"]):
        spoilt = {**value["claims"][-1], name: other}
        path.write_text(json.dumps({**value, "claims": [*value["claims"][:-1], spoilt]}))
        assert check(path)[0] in (1, 2), (name, other)


def test_an_event_may_be_left_out_by_no_list(check: Any, tmp_path: Path) -> None:
    """Neither with a gap between two intervals, nor with one interval across the event; and an
    event of the boundary is told as one of the topology if it is one."""
    certificate = Certificate(*triangle_in_frame())
    certificate.events("5/2", "3")
    path = written(certificate, tmp_path)
    value = json.loads(path.read_text(encoding="utf-8"))
    before, at, after, event, claim = value["claims"]
    none = {"events": [], "scales": [], "kinds": []}
    for of, counts in (([0], {"components": [1], "holes": [1]}), ([2], {"components": [1]})):
        spoilt = {**claim, **none, "intervals": of, "holes": [0], **counts}
        path.write_text(json.dumps({**value, "claims": [before, at, after, event, spoilt]}))
        assert check(path)[0] == 1
    across = {**before, "to": "3", "steps": [*before["steps"], at["step"], *after["steps"]]}
    path.write_text(json.dumps({**value, "claims": [across]}))
    assert check(path)[0] == 1
    boundary = {**event, "kind": "boundary"}
    path.write_text(json.dumps({**value, "claims": [before, at, after, boundary, claim]}))
    assert check(path)[0] == 0
    false = {**claim, "kinds": ["boundary"]}
    path.write_text(json.dumps({**value, "claims": [before, at, after, boundary, false]}))
    assert check(path)[0] == 1


CORRIDOR = "POLYGON((0 0, 5 0, 5 4, 0 4, 0 0), (1 1, 1 2, 4 2, 4 1, 1 1))"
BENT = "POLYGON((0 0, 5 0, 5 5, 0 5, 0 0), (1 1, 1 2, 3 2, 3 4, 4 4, 4 1, 1 1))"
UNIT = "POLYGON((0 0, 1 0, 1 1, 0 1, 0 0))"


@pytest.mark.parametrize("family", FAMILIES)
def test_all_passages(check: Any, tmp_path: Path, family: str) -> None:
    for index in range(draws(1, 3)):
        case = named(f"{family}:{SEED}:{index}")
        certificate = Certificate(case.P, case.Q)
        if not all(o.is_region for o in (case.P, case.Q)):
            with pytest.raises(NoProof, match="both operands have an interior"):
                certificate.sum(case.scale, complete=True)
            continue
        certificate.sum(case.scale, complete=True)
        code, said = check(written(certificate, tmp_path))
        assert code == 0, (case.name.text, said)
        listed = certificate.claims[-1]["passages"]
        assert f"passages: {len(listed)} at {case.scale}, and no others" in said
        assert listed == [*range(1, len(certificate.claims) - 1)]


def test_a_passage_may_be_left_out_by_no_list(check: Any, tmp_path: Path) -> None:
    """Neither the whole, nor a part of one of its two segments, nor by a place that is said to be
    inside solids."""
    certificate = Certificate(*(_core.read_text(text, "wkt", "a test") for text in (BENT, UNIT)))
    certificate.sum(1, complete=True)
    assert Confirmation(certificate.case()).all_hold(certificate.claims)
    path = written(certificate, tmp_path)
    value = json.loads(path.read_text(encoding="utf-8"))
    sum_, passage, claim = value["claims"]
    assert len(passage["path"]) > 2 and check(path)[0] == 0
    shorter = {**passage, "path": passage["path"][1:], "points": passage["points"][1:]}
    ends = sorted(passage["path"][:2])
    said = [[ends, [[0, 0], [1, 0]]]]
    for claims in (
        [{**claim, "passages": []}],
        [{**claim, "passages": [], "inner": [[[passage["path"][1]], [[0, 0]]]]}],
        [shorter, claim],
        [shorter, {**claim, "inner": [*claim["inner"], *said]}],
    ):
        path.write_text(json.dumps({**value, "claims": [sum_, *claims]}))
        code, told = check(path)
        assert code == 1, told
    for other in ({"passages": [1, 1]}, {"passages": [0]}, {"inner": [*claim["inner"], *said]},
                  {"inner": [[]]}, {"step": 0}):  # fmt: skip
        path.write_text(json.dumps({**value, "claims": [sum_, passage, {**claim, **other}]}))
        assert check(path)[0] == 2, other
    assert not Confirmation(certificate.case()).all_hold([sum_, {**claim, "passages": []}])


def test_places_on_seams_are_inside_other_solids(check: Any, tmp_path: Path) -> None:
    """A side between covered cells that no single pair of pieces has inside, in an L less a notch;
    each entry of `inner` is needed, and its pairs are."""
    text = "POLYGON((0 0, 6 0, 6 2, 4 2, 4 3, 6 3, 6 6, 3 6, 3 4, 2 4, 2 6, 0 6, 0 0))"
    P, Q = (_core.read_text(wkt, "wkt", "a test") for wkt in (text, CORRIDOR))
    certificate = Certificate(P, Q)
    certificate.sum("1/2", complete=True)
    path = written(certificate, tmp_path)
    assert check(path)[0] == 0
    value = json.loads(path.read_text(encoding="utf-8"))
    inner = value["claims"][-1]["inner"]
    assert inner
    for k, (ids, pairs) in enumerate(inner):
        for entries, codes in (
            (inner[:k] + inner[k + 1 :], (1,)),
            ([*inner, inner[k]], (2,)),
            ([*inner[:k], [ids, pairs[1:]], *inner[k + 1 :]], (1,)),
            ([*inner[:k], [ids, [*pairs, [10**6, 0]]], *inner[k + 1 :]], (2,)),
        ):
            value["claims"][-1]["inner"] = entries
            path.write_text(json.dumps(value))
            assert check(path)[0] in codes, (k, entries)


def test_what_does_not_hold_has_no_proof() -> None:
    certificate = Certificate(*triangle_in_frame())
    with pytest.raises(NoProof, match="no scales are between"):
        certificate.events(3, 2)
    with pytest.raises(NoProof, match="start or stop meeting"):
        certificate.degeneracy(2)
    with pytest.raises(NoProof, match="is not zero"):
        certificate.zero(("orientation", ((0, 0), (1, 0), (2, 0))), 2)
    with pytest.raises(NoProof, match="has an event at"):
        certificate.interval(2, 3)
    with pytest.raises(NoProof, match="has no event at 2"):
        certificate.event(2, 1)


@pytest.mark.parametrize("name", [f"holes:{SEED}:1", f"touching:{SEED}:2"])
def test_a_changed_sum_is_refused_or_still_proven(check: Any, tmp_path: Path, name: str) -> None:
    """Changed claims and cases are refused; a changed witness may be as good as the old one."""
    print(f"seed {SEED}")
    case = named(name)
    certificate = Certificate(case.P, case.Q)
    certificate.sum(case.scale, passages=True)
    path = written(certificate, tmp_path)
    value = json.loads(path.read_text(encoding="utf-8"))
    dice = random.Random(SEED)
    for mutant in dice.sample(list(mutants(value, 1, dice)), draws(25, 100)):
        path.write_text(json.dumps(mutant.value), encoding="utf-8")
        code, said = check(path)
        assert code in (0, 1, 2), (mutant, said)
        if mutant.path[0] in ("claims", "case", "certificate"):
            assert code, (mutant, said)


def test_a_cell_with_a_seam_through_its_middle(check: Any, tmp_path: Path) -> None:
    """A cell of which many weighted means of the corners lie on one seam between two pieces."""
    text = "POLYGON((0 0, 6 0, 6 4, 0 4, 0 0), (1 2, 3 2, 2 1, 1 2), (3 2, 5 2, 4 1, 3 2))"
    P, Q = (_core.read_text(wkt, "wkt", "a test") for wkt in (text, "POINT(0 0)"))
    certificate = Certificate(P, Q)
    certificate.sum(1)
    assert certificate.claims[0]["holes"] == 2
    assert check(written(certificate, tmp_path))[0] == 0


def test_coordinates_near_the_largest_double(check: Any, tmp_path: Path) -> None:
    """In doubles, sums and products of them are infinite, or no numbers: no filter may decide."""
    size = 2**1020

    def ring(x: int, y: int, width: int, height: int) -> str:
        corners = ((x, y), (x + width, y), (x + width, y + height), (x, y + height), (x, y))
        return "(" + ", ".join(f"{a * size} {b * size}" for a, b in corners) + ")"

    P = _core.read_text(f"POLYGON({ring(0, 0, 9, 6)})", "wkt", "P")
    Q = _core.read_text(f"POLYGON({ring(-2, -2, 13, 12)}, {ring(0, 0, 9, 8)})", "wkt", "Q")
    certificate = Certificate(P, Q)
    certificate.event(1, Fraction(3, 4), passages=True)
    code, said = check(written(certificate, tmp_path))
    assert code == 0, said
