"""Both checkers read each text, number and list of a certificate alike, whatever stands there."""

from __future__ import annotations

import json
import random
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from cubes import CUBE
from file_alone import checker
from minkref import _core
from minkref.certify.plane.certificate import Certificate
from minkref.certify.space.convex_certificate import convex_certificate
from minkref.reports.evidence.certificates.checkers import in_cpp, in_python, verdicts
from replacing import replaced
from thoroughness import draws

SEED = 12
TEXTS = (
    "", " ", "\0", "/", ".", "..", "x/", "x/.", "x\0y", "\\", "//", "-", "+1", "-0", "1/1", "2/2",
    "1_0", "01", "1e0", "1e-1", "1.", ".5", "1.0", "1/0", "1/-1", "0x1", "nan", "inf", "\u0661",
    "\uff11", "\u00e9", "\U0001f600", "a" * 5000, "1" * 3000, "1e400", "1e99999", "\n", "1\n",
)  # fmt: skip
VALUES = (
    None, True, False, 0, 1, -1, 2**63, 2**64, 10**40, 1.0, 1.5, -0.0, 1e300, [], {}, [[]], [0],
    [True], ["1"], {"a": 1}, [[[[[[]]]]]], [None],
)  # fmt: skip
OF_EACH = 2  # of every place
MOST = draws(40, 250)
PATHS = (
    "it.case.json", "./it.case.json", ".//it.case.json", "it.case.json/", "it.case.json/.",
    "it.case.json\0", "it.case.json\0y", "", ".", "/", "..", "../x", "a/../it.case.json",
    "it.case.json/../it.case.json", "\\it.case.json", "IT.CASE.JSON", "it.case.json ",
    " it.case.json", "~/it.case.json", "it%2ecase.json", "file:it.case.json", "a" * 5000,
    "\u00e9.json", "\U0001f600", "-", "it.case.json\n",
)  # fmt: skip


def places(value: Any, at: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    yield at
    if isinstance(value, dict):
        for key in value:
            yield from places(value[key], (*at, key))
    elif isinstance(value, list):
        for k, each in enumerate(value):
            yield from places(each, (*at, k))


def in_the_plane() -> tuple[str, str]:
    frame = _core.PolygonSet.from_json(
        '{"polygons":[{"outer":[[0,0],[4,0],[4,4],[0,4]],"holes":[[[1,1],[1,2],[2,2],[2,1]]]}]}'
    )
    square = _core.PolygonSet.from_json('{"polygons":[{"outer":[[0,0],[1,0],[1,1],[0,1]]}]}')
    certificate = Certificate(frame, square)
    certificate.event("1", "1/2", passages=True)
    certificate.point("1", ("1", "1"))
    certificate.degeneracy("1")
    return certificate.text("it.case.json", "a title"), certificate.case()


def in_space() -> tuple[str, str]:
    vertices = [tuple(vertex) for vertex in CUBE["vertices"]]
    cube = _core.Polyhedron(vertices, CUBE["faces"])
    texts = convex_certificate(cube, cube, [("2", "1", "1/3")], "it.case.json", "a title")
    return texts.certificate, texts.case


def variants(certificate: Any, dice: random.Random) -> Iterator[Any]:
    for at in places(certificate):
        for new in (*dice.sample(TEXTS, OF_EACH), *dice.sample(VALUES, OF_EACH)):
            yield replaced(certificate, at, new)
    for path in PATHS:
        yield replaced(certificate, ("case", "path"), path)


@pytest.mark.parametrize("made", [in_the_plane, in_space], ids=["plane", "space"])
def test_both_checkers_read_them_alike(tmp_path: Path, made: Any) -> None:
    print(f"seed {SEED}")
    certificate, case = made()
    (tmp_path / "it.case.json").write_text(case, encoding="utf-8")
    files = []
    dice = random.Random(SEED)
    every = list(variants(json.loads(certificate), dice))
    kept = every[-len(PATHS) :] + dice.sample(every, min(len(every), MOST))
    for k, value in enumerate(kept):
        files.append(tmp_path / f"{k}.cert.json")
        files[-1].write_text(json.dumps(value, ensure_ascii=False), encoding="utf-8")
    python, cpp = verdicts(in_python(), files), verdicts(in_cpp(), files)
    unlike = [
        (json.loads(file.read_text("utf-8")), one, other)
        for file, one, other in zip(files, python, cpp, strict=True)
        if one.code != other.code
    ]
    assert not unlike, [(first, second) for _, first, second in unlike[:5]]
    assert {verdict.code for verdict in python} >= {0, 2}


def test_a_certificate_without_its_case_is_malformed_to_both(check: Any, tmp_path: Path) -> None:
    certificate, case = in_the_plane()
    (tmp_path / "it.case.json").write_text(case, encoding="utf-8")
    for path in ("it.case.json/", "it.case.json\0y", "it.case.json/.", ""):
        file = tmp_path / "it.cert.json"
        value = replaced(json.loads(certificate), ("case", "path"), path)
        file.write_text(json.dumps(value), encoding="utf-8")
        assert check(file)[0] == 2, path


def test_a_long_text_that_is_no_number_is_refused_at_once() -> None:
    """A grammar that reads digits in two ways takes minutes for these."""
    module = checker()
    since = time.monotonic()
    for text in ("1" * 99_999 + "x", "1/" + "1" * 99_997 + "x", "1." + "0" * 99_997 + "x"):
        with pytest.raises(module.NotVerified, match="is no number"):
            module.number(text)
    assert time.monotonic() - since < 2
