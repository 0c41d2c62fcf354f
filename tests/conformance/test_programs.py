"""The stand-alone programs, run with installed libraries: exit code 0 if the library is right about
the point, 1 if not (here: if the truth is reversed)."""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import subprocess
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.isolation.own_folders import adapters_folder
from minkref.fuzz.libraries.catalogue import absence
from minkref.fuzz.libraries.installation import interpreter
from minkref.fuzz.libraries.program import Program
from minkref.fuzz.libraries.programs import program, why_none
from minkref.fuzz.run.runner import Finding
from minkref.fuzz.run.worker import CaseResult
from minkref.fuzz.unions.asked_union import AskedUnion
from minkref.fuzz.unions.known import KnownUnion, known_unions
from minkref.fuzz.unions.union_witness import UnionOf, some_point
from minkref.fuzz.verdicts.verdict import Outcome, Reason, Verdict, Witness
from thoroughness import THOROUGH

LOST = (
    '{"P":{"polygons":[{"outer":[[0,0],[1,0],[0,1]]}]},"Q":{"polygons":[{"outer":[[5,2],[0,4],[0,0]],'
    '"holes":[[[4,2],[1,1],[1,3]]]}]},"scale":"1"}'
)
SLIVER = (
    '{"P":{"polygons":[{"outer":[[0,2],[0,0],[18,1]]}]},'
    '"Q":{"polygons":[{"outer":[[0,1],[1,0],[1,1]]}]},"scale":"1"}'
)
TETRAHEDRON = (
    '{"vertices":[[%s,0,0],[%s,0,1],[%s,1,0],[%s,0,0]],"faces":[[0,1,2],[0,2,3],[0,3,1],[1,3,2]]}'
)
AT_ORIGIN = TETRAHEDRON % (0, 0, 0, 1)
FAR_AWAY = TETRAHEDRON % (9, 9, 9, 10)
SPACE = '{"P":%s,"Q":%s,"scale":"1"}' % (AT_ORIGIN, FAR_AWAY)  # noqa: UP031
SECONDS = 400
KEPT = Path(__file__).resolve().parents[2] / "build" / "conformance" / "programs"
CGAL = Path("/usr/include/CGAL/version.h")


def built_and_run(made: Program, target: str, folder: Path) -> tuple[int, str]:
    """Exit code and output, with the library of the adapter."""
    (folder / made.file).write_text(made.text, encoding="utf-8")
    home = adapters_folder()
    if made.file.endswith(".py"):
        words = [str(interpreter(home / target.removesuffix("-space"))), made.file]
    elif made.file.endswith(".scad"):
        words = ["openscad", "-o", f"out{'.off' if 'off' in made.run else '.svg'}", made.file]
    else:
        compiler = shutil.which("g++")
        if compiler is None:
            pytest.skip("there is no g++")
        flags = ["-std=c++17", "-O0", "-w", "-frounding-math"]
        if target.startswith("clipper2"):
            (library,) = (home / "clipper2" / "source").glob("*/external/clipper2/CPP/Clipper2Lib")
            flags += [f"-I{library}/include", *map(str, (library / "src").glob("clipper.*.cpp"))]
        end = ["-lmpfr", "-lgmp"] if target.startswith("cgal") else []
        words = [str(compiled(made.text, [compiler, *flags, made.file], end, folder))]
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True, timeout=SECONDS)
    return done.returncode, done.stdout + done.stderr


def compiled(text: str, words: list[str], end: list[str], folder: Path) -> Path:
    """The binary; kept for the same text, compiler and CGAL."""
    said = subprocess.run([words[0], "--version"], capture_output=True, text=True, check=True)
    key = [text, *words, said.stdout, CGAL.read_text() if CGAL.is_file() else ""]
    kept = KEPT / hashlib.sha256(json.dumps(key).encode()).hexdigest()
    if not kept.is_file():
        words = [*words, "-o", "program", *end]
        done = subprocess.run(words, cwd=folder, capture_output=True, text=True, timeout=SECONDS)
        assert done.returncode == 0, done.stderr[-3000:]
        KEPT.mkdir(parents=True, exist_ok=True)
        shutil.copy(folder / "program", f"{kept}.{os.getpid()}")
        os.replace(f"{kept}.{os.getpid()}", kept)
    return kept


def skip_without(target: str) -> None:
    reason = absence(target)
    if reason is not None:
        pytest.skip(reason)


def turned(finding: Finding) -> Finding:
    """The finding with its witness on the other side: a right library then has a fault."""
    witness = finding.outcome.witness
    assert witness is not None
    outcome = replace(finding.outcome, witness=replace(witness, in_truth=not witness.in_truth))
    return Finding(outcome, finding.case)


CASES = [
    ("clipper2", SLIVER, ("10", "2"), True),
    pytest.param("clipper2-double", SLIVER, ("10", "1"), True, marks=pytest.mark.thorough),
    ("boost-polygon", LOST, ("11/5", "5/2"), True),
    ("pysfcgal", SLIVER, ("10", "1"), True),
    ("pysfcgal", LOST, ("11/5", "5/2"), False),
    ("pysfcgal-space", SPACE, ("10", "1/3", "1/3"), True),
    ("manifold3d", SPACE, ("10", "1/3", "1/3"), True),
    ("manifold3d", SPACE, ("1/10", "1/5", "1/5"), False),
    ("openscad", LOST, ("11/5", "5/2"), True),
    ("openscad", LOST, ("1/2", "1"), True),
    ("openscad", SPACE, ("10", "1/3", "1/3"), True),
    pytest.param(
        "clipper2-region", SLIVER, ("21/4", "64583333/50000000"), True, marks=pytest.mark.thorough
    ),
]


@pytest.mark.parametrize(("target", "case", "point", "right"), CASES)
def test_program_tells_whether_the_library_is_right(
    target: str,
    case: str,
    point: tuple[str, ...],
    right: bool,
    finding: Callable[..., Finding],
    tmp_path: Path,
) -> None:
    skip_without(target)
    found = finding(case, target, point, reasons=(Reason.EXTRA,))
    made = program(found, "fault")
    assert made is not None
    assert "minkref" not in made.text.replace("fuzz/adapters", "")
    code, said = built_and_run(made, target, tmp_path)
    assert code == (0 if right else 1), said
    if right and not made.file.endswith(".cpp"):
        other = program(turned(found), "fault")
        assert other is not None
        assert built_and_run(other, target, tmp_path)[0] == 1


@pytest.mark.thorough  # CGAL compiles for half a minute; those for other libraries are always run
@pytest.mark.parametrize("target", ["cgal-hull", "cgal-nef"])
def test_program_for_cgal_in_space(
    target: str, finding: Callable[..., Finding], tmp_path: Path
) -> None:
    skip_without(target)
    found = finding(SPACE, target, ("10", "1/3", "1/3"), reasons=(Reason.MISSING,))
    made = program(turned(found), "fault")
    assert made is not None
    code, said = built_and_run(made, target, tmp_path)
    assert code == 1, said
    assert "in this sum: in, in truth: out" in said


def test_without_a_witness_there_is_the_call_alone(finding: Callable[..., Finding]) -> None:
    for target in ("clipper2", "boost-polygon", "pysfcgal", "openscad", "cgal-reduced"):
        made = program(finding(SLIVER, target, verdict=Verdict.CRASHED, signal="SIGSEGV"), "fault")
        assert made is not None
        assert "CRASHED" not in made.text
        assert "crashed" in made.text
    made = program(finding(SPACE, "manifold3d", verdict=Verdict.TIMED_OUT), "fault")
    assert made is not None
    compile(made.text, "fault.py", "exec")


def test_operands_that_a_library_does_not_take_have_no_program(
    finding: Callable[..., Finding],
) -> None:
    for target, case in (
        ("clipper2", LOST),
        ("cgal-nef", LOST),
        ("cgal-reduced", SPACE),
        ("cgal-full", LOST),
        ("pysfcgal", SPACE),
        ("pysfcgal-space", LOST),
    ):
        found = finding(case, target, verdict=Verdict.CRASHED)
        assert program(found, "fault") is None, target
        assert "not called with such operands" in why_none(found)
    for target in ("./mine.py", "py:a:b", "so:./x.so:f", "cmd:node x.js"):
        found = finding(LOST, target, verdict=Verdict.CRASHED)
        assert program(found, "fault") is None
        assert "itself the program" in why_none(found)


def test_numbers_beyond_the_digits_of_doubles_are_in_the_program(
    finding: Callable[..., Finding],
) -> None:
    text = json.dumps(
        {
            "P": {"polygons": [{"outer": [["1/3", 0], [7, 0], [0, "5/7"]]}]},
            "Q": {"polygons": [{"outer": [[0, 0], [1, 0], [0, 1]]}]},
            "scale": "9/7",
        }
    )
    made = program(finding(text, "pysfcgal", ("1", "1")), "fault")
    assert made is not None
    assert "3/7 0" in made.text


FIRST = {"geos": "GEOS", "boost-geometry": "Boost.Geometry"}
UNIONS = known_unions()


def union_finding(known: KnownUnion, target: str, witness: Witness | None) -> Finding:
    case = AskedUnion(CaseName("union", "named"), known.sets)
    result = CaseResult(0, case.name, "1", [], "P", "Q", case.size, literal=case.literal)
    return Finding(Outcome(target, Verdict.WRONG, (Reason.MISSING,), witness=witness), result)


def target_of(known: KnownUnion) -> str:
    victim = known.victims[0]
    if victim.endswith("on a grid"):
        return "geos-grid"
    return next(target for target, name in FIRST.items() if victim.startswith(name))


def shown() -> list[KnownUnion]:
    """Of each target the first, as a C++ program is compiled; all when thorough."""
    found = [known for known in UNIONS if known.witness is not None]
    firsts = {target_of(known): known for known in found[::-1]}
    return found if THOROUGH else list(firsts.values())


@pytest.mark.parametrize("known", shown(), ids=lambda known: known.title)
def test_a_program_shows_a_known_fault(known: KnownUnion, tmp_path: Path) -> None:
    target = target_of(known)
    skip_without(target)
    made = program(union_finding(known, target, known.witness), "fault")
    assert made is not None and "minkref" not in made.text
    code, said = built_and_run(made, "shapely" if made.file.endswith(".py") else target, tmp_path)
    assert code == 1, said
    assert "in this union: " in said


def test_a_program_finds_right_what_is_right(tmp_path: Path) -> None:
    skip_without("geos")
    for known in UNIONS[1:4]:
        witness = some_point(AskedUnion(CaseName(known.title, "known"), known.sets))
        inner = replace(witness, point=_moved(witness.point))
        assert UnionOf(AskedUnion(CaseName(known.title, "known"), known.sets)).holds(inner)
        made = program(union_finding(known, "geos", inner), "fault")
        assert made is not None
        code, said = built_and_run(made, "shapely", tmp_path)
        assert code == 0, said


def _moved(point: tuple[str, ...]) -> tuple[str, ...]:
    """A little to the upper right of a lower left corner."""
    return tuple(f"{int(number) * 8 + 1}/8" for number in point)


def test_other_libraries_have_none() -> None:
    for target in ("clipper2-region", "boost-polygon", "cgal-join"):
        found = union_finding(UNIONS[1], target, None)
        assert program(found, "fault") is None
        assert "show sums" in why_none(found)
    assert "is itself" in why_none(union_finding(UNIONS[1], "./mine", None))
