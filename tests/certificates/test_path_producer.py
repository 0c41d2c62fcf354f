"""Paths and traps: what the producer writes is verified by both checkers, and is what the reference
says of all scales."""

from __future__ import annotations

import json
import random
from collections.abc import Callable
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from typing import Any

import minkref
import pytest
from minkref.certify.motion.path_certificate import PathCertificate
from minkref.certify.motion.scale_cells import document
from minkref.certify.plane.certificate import NoProof
from minkref.fuzz.motion.path_cases import path_case
from minkref.motion.scale_ranges import ScaleRange
from minkref.reports.evidence.certificates.checkers import in_cpp, in_python, verdicts
from thoroughness import draws

SEED = 29
CONTACTS = ("allowed", "forbidden")
ALL = ScaleRange(Fraction(0), None, False, False)
SQUARE = minkref.PolygonSet([(-1, -1), (1, -1), (1, 1), (-1, 1)])
FRAME = minkref.PolygonSet(
    [[[(-2, -2), (2, -2), (2, 2), (-2, 2)], [(-1, -1), (-1, 1), (1, 1), (1, -1)]]]
)


def written(certificate: PathCertificate, folder: Path, stem: str) -> Path:
    (folder / f"{stem}.case.json").write_text(certificate.case(), encoding="utf-8")
    file = folder / f"{stem}.cert.json"
    file.write_text(certificate.text(f"{stem}.case.json", stem), encoding="utf-8")
    return file


def verified(files: list[Path]) -> None:
    for command in (in_python(), in_cpp()):
        for file, verdict in zip(files, verdicts(command, files), strict=True):
            assert verdict.code == 0, (command[-1], file.read_text(encoding="utf-8"), verdict.why)


def test_random_paths_are_proven_at_all_scales(tmp_path: Path) -> None:
    files, without = [], 0
    for k in range(count := draws(20, 60)):
        case = path_case(SEED, k)
        for contact in CONTACTS:
            certificate = PathCertificate(case.part, case.obstacles, case.path)
            try:
                certificate.valid(contact)
            except NoProof:
                without += 1
                assert contact == "allowed"
                assert not (case.part.is_region and case.obstacles.is_region)
                continue
            found = minkref.valid_scales(case.part, case.obstacles, case.path, contact)
            assert certificate.claims[-1]["valid"] == [document(one) for one in found.ranges]
            files.append(written(certificate, tmp_path, f"{k}-{contact}"))
    assert len(files) >= 5 * count / 3 and without < count / 6, f"seed {SEED}"
    verified(files)


def test_random_traps_are_proven_at_all_scales(tmp_path: Path) -> None:
    """A part that may be anywhere beside its origin, so that nothing is nested."""
    files, trapped = [], 0
    for k in range(count := draws(12, 48)):
        case = path_case(SEED, k)
        place = case.path[:1]
        for contact in CONTACTS:
            certificate = PathCertificate(case.part, case.obstacles, place)
            try:
                certificate.trap(contact)
            except (NoProof, minkref.BadInput) as error:
                assert "seam" in str(error) or "rings touch" in str(error), error
                continue
            found = minkref.trapped_scales(case.part, case.obstacles, place[0], contact)
            assert certificate.claims[-1]["trapped"] == [document(one) for one in found.ranges]
            trapped += bool(found.ranges)
            files.append(written(certificate, tmp_path, f"{k}-{contact}"))
    assert len(files) > 5 * count / 8 and trapped > count / 24, f"seed {SEED}"
    verified(files)


@pytest.mark.parametrize("contact", CONTACTS)
@pytest.mark.parametrize(
    ("part", "obstacles", "held"),
    [
        (SQUARE, FRAME, "(0, 1"),  # until it touches all around
        (FRAME, SQUARE, "1, inf)"),  # a frame around a square, for ever
        (FRAME.translated("1/2", "0"), SQUARE, "2, inf)"),
        (SQUARE.translated("5", "0"), FRAME, "(0, 1/6"),
    ],
)
def test_traps_of_frames(
    check: Callable[..., Any], tmp_path: Path, part: Any, obstacles: Any, held: str, contact: str
) -> None:
    """Rings that grow with the scale, without end too."""
    found = minkref.trapped_scales(part, obstacles, (0, 0), contact)
    assert held in str(found.ranges[-1])
    certificate = PathCertificate(part, obstacles, [(0, 0)])
    certificate.trap(contact)
    code, said = check(written(certificate, tmp_path, "frame"))
    assert code == 0, said


def test_what_does_not_hold_has_no_proof() -> None:
    walls = minkref.PolygonSet([(1, 0), (4, 0), (4, 1), (1, 1)])
    part = minkref.PolygonSet([(2, 0), (3, 0), (3, 1), (2, 1)])
    certificate = PathCertificate(part, walls, [(0, 0)])
    assert certificate.free(ScaleRange(Fraction(0), Fraction(1, 3), False, True)) == 0
    with pytest.raises(NoProof):
        certificate.free(ScaleRange(Fraction(0), Fraction(2, 3), False, True))
    with pytest.raises(NoProof):
        certificate.hit(ScaleRange(Fraction(1, 3), Fraction(1), True, True))
    with pytest.raises(NoProof):
        certificate.valid(ranges=[ALL])
    with pytest.raises(NoProof):
        certificate.valid(ranges=[])


def window(low: str, high: str) -> ScaleRange:
    return ScaleRange(Fraction(low), Fraction(high), True, True)


@pytest.mark.parametrize("factor", ["1", "1000000000000000000000001/3", "1/987654321987654321"])
def test_size_does_not_matter(tmp_path: Path, factor: str) -> None:
    """Huge and tiny numbers: what is certified is that of the case at its usual size."""
    dice = random.Random(SEED)
    files = []
    for k in range(6):
        case = path_case(SEED + 1, dice.randrange(100))
        if not (case.part.is_region and case.obstacles.is_region):
            continue
        far = Fraction(factor)
        path = [(far * x, far * y) for x, y in case.path]
        certificate = PathCertificate(case.part.scaled(factor), case.obstacles.scaled(factor), path)
        certificate.valid()
        found = minkref.valid_scales(case.part, case.obstacles, case.path)
        assert certificate.claims[-1]["valid"] == [document(one) for one in found.ranges]
        files.append(written(certificate, tmp_path, str(k)))
    assert files
    verified(files)


@pytest.mark.parametrize("contact", CONTACTS)
def test_windows_end_where_they_are_told_to(
    tmp_path: Path, contact: str, check: Callable[..., Any]
) -> None:
    case = path_case(SEED, 1)
    found = minkref.valid_scales(case.part, case.obstacles, case.path, contact)
    ends = sorted({bound.scale for bound in found.bounds} | {Fraction(1, 7), Fraction(9)})
    for number, (low, high) in enumerate(pairwise(ends)):
        certificate = PathCertificate(case.part, case.obstacles, case.path)
        certificate.valid(contact, low, high)
        assert certificate.claims[-1]["scales"] == document(window(str(low), str(high)))
        code, said = check(written(certificate, tmp_path, str(number)))
        assert code == 0, said
    certificate = PathCertificate(case.part, case.obstacles, case.path)
    certificate.valid(contact, ends[0], ends[0])
    assert check(written(certificate, tmp_path, "one"))[0] == 0


def test_empty_sets_and_a_path_that_stands_still(tmp_path: Path, check: Callable[..., Any]) -> None:
    nothing = minkref.PolygonSet([])
    for part, walls in ((nothing, SQUARE), (SQUARE, nothing), (nothing, nothing)):
        certificate = PathCertificate(part, walls, [(0, 0), (0, 0), (1, 1)])
        certificate.valid()
        assert [one["from"] for one in certificate.claims[-1]["valid"]] == ["0"]
        assert check(written(certificate, tmp_path, "nothing"))[0] == 0
    with pytest.raises(minkref.errors.Refusal):
        PathCertificate(SQUARE, SQUARE, [])


def test_a_long_path_among_many_pieces(tmp_path: Path, check: Callable[..., Any]) -> None:
    """Ways between pillars, far longer than the part: the proof grows with what is near."""
    pillars = [[[(x, y), (x + 3, y), (x + 3, y + 3), (x, y + 3)]]
               for x in range(0, 100, 10) for y in range(0, 50, 10)]  # fmt: skip
    walls = minkref.PolygonSet(pillars)
    path = [(-5, -5), (105, -5), (105, "13/2"), (-5, "13/2"), (-5, "33/2"), (105, "33/2")]
    certificate = PathCertificate(SQUARE, walls, path)
    certificate.valid()
    assert certificate.claims[-1]["valid"][0]["to"] == "7/2"
    assert len(certificate.text("it")) < 20_000
    code, said = check(written(certificate, tmp_path, "long"))
    assert code == 0, said
    json.loads(certificate.case())
