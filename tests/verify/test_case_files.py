"""`minkref verify --suite corpus`: each target gets the case files in the plane and in space that
it takes; the run names omitted cases, and refuses unreadable ones."""

from __future__ import annotations

import json
import shutil
import sys
from collections.abc import Callable, Iterable
from fractions import Fraction
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from minkref.cli.cli import run
from minkref.degeneracies import lint
from minkref.degeneracies.catalogue import SOLID_FAMILIES
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.space.case import known_pair
from minkref.fuzz.space.cells import surface_of
from minkref.fuzz.space.pair import Truth

CUBE = (
    f"cmd:{sys.executable} {Path(__file__).parent / 'bad_adapters' / 'bad_adapter.py'} space-cube"
)
OURS = ("minkref:convex", "minkref:convex-dynamic")
Change = Callable[[Any], object]


@pytest.fixture
def minkref(capsys: pytest.CaptureFixture[str], follows_schema: Callable[[Any, str], None]) -> Any:
    def call(*arguments: str | Path) -> tuple[int, Any]:
        code = run([*(str(argument) for argument in arguments), "--json"])
        value = json.loads(capsys.readouterr().out)
        if "error" not in value:
            follows_schema(value, str(arguments[0]))
        return code, value

    return call


def corpus(folder: Path, *families: str) -> tuple[str | Path, ...]:
    """Options for a corpus that holds exactly these families."""
    for family in families:
        shutil.copytree(lint.CORPUS / family, folder / family)
    return ("--suite", "corpus", "--corpus", folder, "--jobs", "1")


def cases_in(*families: str) -> int:
    paths = [path for family in families for path in lint.case_paths(lint.CORPUS / family)]
    return sum(len(json.loads(path.read_text(encoding="utf-8"))["scales"]) for path in paths)


def verdicts(value: Any) -> dict[str, dict[str, int]]:
    return {row["target"]: row["verdicts"] for row in value["matrix"]}


def test_polycubes_at_a_fine_scale_are_judged_by_the_exact_sum() -> None:
    """At scale n/d, the cell count of a polycube sum grows with the cube of n + d."""
    slot = lint.CORPUS / "solids-slot-closes"
    for path in lint.case_paths(slot):
        value = json.loads(path.read_text(encoding="utf-8"))
        P, Q = (Polyhedron.from_document(value[name]) for name in "PQ")
        fine = [known_pair(P, Q, Fraction(scale[0])).truth for scale in value["scales"][2::2]]
        assert fine == [Truth.SUM] * 2
    cube = surface_of({(0, 0, 0)})
    hollow = cube.with_faces_of(cube.translated((Fraction(3),) * 3))
    assert known_pair(hollow, cube, Fraction(1, 2)).truth is Truth.CELLS
    assert known_pair(hollow, cube, Fraction(1, 2**60)).truth is Truth.SUM


@pytest.mark.thorough
def test_targets_in_space_have_the_cases_in_space_of_the_corpus(minkref: Any) -> None:
    """Repeats `test_targets_in_space_have_those_in_space` with the whole shipped corpus."""
    space = [p for p in lint.CORPUS.iterdir() if '"dimension": 3' in first(p)]
    plane = sum(len(lint.case_paths(p)) for p in lint.CORPUS.iterdir() if p not in space)
    convex = [p.name for p in space if p.name not in SOLID_FAMILIES]
    assert cases_in(*convex) > 250 and cases_in(*SOLID_FAMILIES) > 200
    space_alone(minkref("verify", *OURS, "--suite", "corpus"), convex, SOLID_FAMILIES, plane)


def test_targets_in_space_have_those_in_space(minkref: Any, tmp_path: Path) -> None:
    """Takes all cases in space, at all scalings, except polyhedra that are not convex. The run
    tells how many cases in the plane it omits."""
    convex, solids = ["with-itself", "facets-parallel-always"], [next(iter(SOLID_FAMILIES))]
    options = corpus(tmp_path / "cases", *convex, *solids, "euler-zero")
    plane = len(lint.case_paths(lint.CORPUS / "euler-zero"))
    space_alone(minkref("verify", *OURS, *options), convex, solids, plane)


def space_alone(done: Any, convex: list[str], solids: Iterable[str], plane: int) -> None:
    code, value = done
    assert code == 0
    count, skipped = cases_in(*convex), cases_in(*solids)
    assert verdicts(value) == {target: {"pass": count, "skipped": skipped} for target in OURS}
    assert value["notes"] == [
        f"left out: {plane} case files in the plane, where no target takes operands"
    ]


def first(folder: Path) -> str:
    return lint.case_paths(folder)[0].read_text(encoding="utf-8")


def test_targets_in_the_plane_have_those_in_the_plane(minkref: Any, tmp_path: Path) -> None:
    options = corpus(tmp_path / "cases", "euler-zero", "with-itself")
    code, value = minkref("verify", "minkref:paper", *options)
    assert (code, verdicts(value)["minkref:paper"]) == (0, {"pass": cases_in("euler-zero")})
    assert value["notes"] == ["left out: 3 case files in space, where no target takes operands"]


def test_targets_of_both_kinds_have_all(minkref: Any, tmp_path: Path) -> None:
    """The run omits nothing; targets skip the cases that they do not take, and the skips are
    counted."""
    options = corpus(tmp_path / "cases", "euler-zero", "with-itself")
    code, value = minkref("verify", "minkref:paper", "minkref:convex", *options)
    plane, space = cases_in("euler-zero"), cases_in("with-itself")
    assert (code, value["notes"]) == (0, [])
    assert verdicts(value) == {
        "minkref:paper": {"pass": plane, "skipped": space},
        "minkref:convex": {"pass": space, "skipped": plane},
    }


@pytest.mark.parametrize(
    ("target", "family", "told", "mend"),
    [
        ("minkref:paper", "with-itself", "all case files in this folder are in space", "in space"),
        ("minkref:convex", "euler-zero", "are in the plane", "in the plane"),
        ("minkref:convex", None, "there is no case file", "--corpus"),
    ],
)
def test_a_folder_without_a_case_for_any_target_is_refused(
    minkref: Any, tmp_path: Path, target: str, family: str | None, told: str, mend: str
) -> None:
    options = corpus(tmp_path / "cases", *([family] if family else []))
    code, value = minkref("verify", target, *options)
    error = value["error"]
    assert (code, error["code"], error["where"]) == (2, "no-case-files", str(tmp_path / "cases"))
    assert told in error["what"] and mend in error["mend"]


def changed(folder: Path, change: Change) -> Path:
    path = lint.case_paths(lint.CORPUS / "with-itself")[0]
    value = json.loads(path.read_text(encoding="utf-8"))
    change(value)
    folder.mkdir()
    (folder / "it.json").write_text(json.dumps(value), encoding="utf-8")
    return folder / "it.json"


@pytest.mark.parametrize(
    ("change", "code"),
    [
        (lambda v: v.pop("Q"), "missing-member"),
        (lambda v: v["P"].pop("faces"), "missing-member"),
        (lambda v: v["P"]["faces"].pop(), "not-closed"),
        (lambda v: v["Q"]["vertices"][0].__setitem__(0, "1/0"), "zero-denominator"),
        (lambda v: v.pop("scales"), "missing-member"),
        (lambda v: v.__setitem__("scales", "1"), "missing-member"),
        (lambda v: v.__setitem__("scales", ["1"]), "wrong-type"),
        (lambda v: v["scales"][-1].pop(), "wrong-type"),
        (lambda v: v["scales"][-1].__setitem__(0, 0.5), "wrong-type"),
        (lambda v: v["scales"][-1].__setitem__(0, "0"), "scale-zero"),
        (lambda v: v["scales"][-1].__setitem__(2, "-1"), "scale-negative"),
    ],
)
@pytest.mark.parametrize("target", ["minkref:convex", "minkref:paper"])
def test_a_bad_case_in_space_is_refused(
    minkref: Any, tmp_path: Path, change: Change, code: str, target: str
) -> None:
    """The case is refused before the run, by file name, whether or not the run would omit it."""
    path = changed(tmp_path / "cases", change)
    options = corpus(tmp_path / "cases", "euler-zero", "facets-parallel-always")
    ran, value = minkref("verify", target, *options)
    assert (ran, value["error"]["code"]) == (2, code)
    assert value["error"]["where"].startswith(str(path)) and value["error"]["mend"]
    assert minkref("verify", target, "--case", path)[0] == 2


def test_a_case_in_space_may_have_decimals_and_whole_numbers(minkref: Any, tmp_path: Path) -> None:
    """Exact numbers in the spellings that the schema allows."""

    def change(value: Any) -> None:
        value["scales"] = [["0.5", 2, "3e-1"]]
        value["P"]["vertices"] = [
            [int(c) if "/" not in c else c for c in v] for v in value["P"]["vertices"]
        ]

    path = changed(tmp_path / "cases", change)
    code, value = minkref("verify", *OURS, "cgal-hull", *corpus(tmp_path / "cases"))
    assert code == 0 and {tuple(v) for v in verdicts(value).values()} == {("pass",)}
    assert minkref("verify", *OURS, "--case", f"{path}@1/2,2,3/10")[0] == 0


def test_a_fault_on_a_case_file_in_space_is_found_and_made_small(
    minkref: Any, tmp_path: Path
) -> None:
    """Every answer of the adapter is a cube. The shrunk case is a case file in space, and shows the
    fault again."""
    path = changed(tmp_path / "cases", lambda v: v.__setitem__("scales", [["2", "2", "2"]]))
    code, value = minkref("verify", CUBE, *corpus(tmp_path / "cases"), "--shrink-calls", "0")
    (finding,) = value["findings"]
    assert (code, finding["verdict"], finding["case"]) == (1, "wrong", f"{path}@2")
    assert finding["witness"]
    small = tmp_path / "small.json"
    code, value = minkref("shrink", path, "--target", CUBE, "-o", small, "--calls", "40")
    written = json.loads(small.read_text(encoding="utf-8"))
    form = json.loads((lint.ROOM / "schema" / "case-v1.json").read_text(encoding="utf-8"))
    jsonschema.validate(written, form)
    assert (code, written["dimension"], len(written["scales"][0])) == (1, 3, 3)
    assert len(written["P"]["vertices"]) == 4
    assert minkref("verify", CUBE, "--case", small)[0] == 1


def test_a_shrunk_case_that_is_not_convex_has_no_case_file(minkref: Any, tmp_path: Path) -> None:
    words = ("--target", CUBE, "-o", tmp_path / "small.json", "--calls", "0")
    code, value = minkref("shrink", "space-torus:1:3", *words)
    assert (code, (tmp_path / "small.json").exists()) == (2, False)
    assert "convex" in value["error"]["what"]
