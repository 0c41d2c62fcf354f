"""Certificates of the producer are verified by both checkers; changed certificates are not."""

from __future__ import annotations

import json
import random
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from minkref import _core
from minkref.certify.plane.certificate import Certificate, NoProof
from minkref.exact import digest
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


def test_what_does_not_hold_has_no_proof() -> None:
    certificate = Certificate(*triangle_in_frame())
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
