"""Plants faults into the reference, and finds the judge, law or test that catches each fault.

The patches of tests/planted/ put the faults into a copy of the reference; the environment variable
MINKREF_FAULT switches one on. Plane faults face the reference's laws and tests, its own routes
against each other, and the judges of `minkref verify minkref`; space faults face the laws and tests
of space, disc faults the disc's laws and tests.

`python -m minkref.reports.evidence.planted_faults.faults [FAULT...]` plants only the named faults
(without names, the faults missing from the table) and renews their rows. Exit code 1: a fault is
not caught, or an alarm sounds without a fault; after an alarm the table stays unchanged.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import tempfile
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

from minkref.fuzz.plane.judgement import TRUTHS
from minkref.reports.evidence.framework.of_tests import module
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.framework.places import ROOM, ROOT

MINUTES = Minutes(None, 10, 50)  # it builds

planted = module("planted", ROOT / "tools" / "scripts")
SOURCES = ROOT / "build" / "faults" / "source"  # kept, and only what changed is written again
BUILD = SOURCES.with_name("release")
TABLE = ROOM / "planted_faults.md"
SUITES = ("plane", "plane/critical", "plane/dynamic", "plane/index")
SPACE_SUITES = ("number", "space", "space/sums", "space/surface")
DISC_SUITES = ("disc",)
EVERY_SUITE = (*SUITES, *SPACE_SUITES, *DISC_SUITES)
RESTS_ON = (
    "CMakeLists.txt", "tools/cmake/", "tools/scripts/planted.py", "formats/", "reference/",
    "tests/CMakeLists.txt", "tests/planted/", *(f"tests/{suite}/" for suite in EVERY_SUITE),
)  # fmt: skip
PYTEST_FOLDERS = ("tests/plane", "tests/plane/dynamic")
ROUTES = TRUTHS
EXTENSION = "_core"
PAIRS = 60
SUITE_SECONDS, VERIFY_SECONDS, PYTEST_SECONDS = 300, 150, 150
FEWEST = 25
FEWEST_OF_LIST = {"plane": FEWEST, "space": FEWEST, "disc": 12}
JOBS = 2
EVERY = Counts(0, 6, 1)  # one fault of so many


@dataclass
class Caught:
    """Names of `verify` targets, suites and tests that caught a fault."""

    judges: list[str] = field(default_factory=list)
    routes: list[str] = field(default_factory=list)
    tests: list[str] = field(default_factory=list)

    def __bool__(self) -> bool:
        return bool(self.judges or self.routes or self.tests)


@cache
def listed(where: str = "*") -> dict[str, str]:
    """The faults, or a folder's faults, with descriptions."""
    found: dict[str, str] = planted.listed(where)
    return found


def program(suite: str) -> str:
    return f"test_{suite.replace('/', '_')}"


def build(*targets: str) -> None:
    """Builds everything, or these targets; links the package with the extension module, if it is
    one of them."""
    planted.copy(SOURCES)
    words = ["cmake", "--build", str(BUILD), "-j", "2"]
    is_linked = not targets or EXTENSION in targets
    for command in (
        ["cmake", "-S", str(SOURCES), "-B", str(BUILD), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
         "-DMINKREF_CGAL=OFF", "-DMINKREF_PYTHON=ON", f"-DPython_EXECUTABLE={sys.executable}"],
        [*words, "--target", *targets] if targets else words,
        *([[sys.executable, "tools/scripts/link_package.py", str(BUILD)]] if is_linked else []),
    ):  # fmt: skip
        done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
        if done.returncode:
            raise RuntimeError(f"{' '.join(command)}: {(done.stderr or done.stdout)[-2000:]}")


def ended(
    fault: str, seconds: float, *command: str | Path
) -> subprocess.CompletedProcess[str] | None:
    """Runs a command with the fault planted; None if the command does not end."""
    variables = {
        **os.environ, "MINKREF_FAULT": fault, "PYTHONPATH": str(BUILD / "package"),
        "PYTHONSAFEPATH": "1",  # hides the checkout's package, despite the working folder
    }  # fmt: skip
    try:
        return subprocess.run(
            command, cwd=ROOT, env=variables, capture_output=True, text=True, errors="replace",
            check=False, timeout=seconds,
        )  # fmt: skip
    except subprocess.TimeoutExpired:
        return None


def laws(fault: str, suites: tuple[str, ...]) -> list[str]:
    """Each reference suite's first failing test; a suite that ends with a signal, or never, has
    also caught the fault."""
    failed = []
    for suite in suites:
        with tempfile.NamedTemporaryFile(suffix=".json") as report:
            done = ended(
                fault, SUITE_SECONDS, BUILD / "tests" / suite / program(suite),
                f"--gtest_output=json:{report.name}", "--gtest_fail_fast",
            )  # fmt: skip
            if done is None:
                failed.append(f"{suite}: no end in {SUITE_SECONDS} s")
                continue
            text = Path(report.name).read_text(encoding="utf-8")
        found = [
            f"{test['classname']}.{test['name']}"
            for group in (json.loads(text)["testsuites"] if text else [])
            for test in group["testsuite"]
            if test.get("failures")
        ]
        if done.returncode and not found:
            found = [f"{suite}: exit code {done.returncode}"]
        failed += found
    return failed


def python_tests(fault: str) -> list[str]:
    """The first failing test, among hand-made tight passages and parents by definition."""
    words = ("-m", "pytest", "-qx", "-p", "no:cacheprovider", *PYTEST_FOLDERS)
    done = ended(fault, PYTEST_SECONDS, sys.executable, *words)
    if done is None:
        return [f"{' '.join(PYTEST_FOLDERS)}: no end"]
    found = re.findall(r"^(?:FAILED|ERROR) \S+?::(.+?)(?: - |$)", done.stdout, re.MULTILINE)
    return found or ([f"pytest: exit code {done.returncode}"] if done.returncode else [])


def before_judges(fault: str, caught: Caught) -> None:
    """The judges, and our own routes against each other, on the same cases."""
    bad = seen(fault, PAIRS, VERIFY_SECONDS, "minkref", *ROUTES)
    if bad is None:
        caught.judges.append("verify: no end")
        return
    for target, count in bad.items():
        if count:
            where = caught.routes if target in ROUTES else caught.judges
            where.append(f"{target.removeprefix('minkref@')} ({count})")


def seen(fault: str, pairs: int, seconds: float, *targets: str) -> Counter[str] | None:
    """Cases in which each target is wrong, or the reference fails; None without an answer."""
    words = ("-m", "minkref", "verify", *targets, "--pairs", str(pairs), "--no-models")
    more = ("--json", "--jobs", "1", "--shrink-calls", "0")
    done = ended(fault, seconds, sys.executable, *words, *more)
    try:
        matrix = json.loads(done.stdout if done is not None else "")["matrix"]
    except (ValueError, KeyError):
        return None
    bad: Counter[str] = Counter()  # a row is a target on a family
    for row in matrix:
        bad[row["target"]] += sum(
            n for verdict, n in row["verdicts"].items() if verdict not in ("pass", "skipped")
        )
    return bad


def put_in(fault: str) -> Caught:
    """Runs the laws, tests and judges meant for this fault; without a fault, all."""
    caught = Caught()
    if not fault or fault in listed("plane"):
        caught.tests += laws(fault, SUITES) + python_tests(fault)
        before_judges(fault, caught)
    if not fault or fault not in listed("plane"):
        caught.tests += laws(fault, _suites([fault] if fault else list(listed())))
    print(f"{fault or 'none'}: {'caught' if caught else 'not caught'}", flush=True)
    return caught


def _suites(faults: list[str]) -> tuple[str, ...]:
    """The suites for faults outside the plane."""
    chosen: tuple[str, ...] = ()
    for where, suites in (("space", SPACE_SUITES), ("disc", DISC_SUITES)):
        if set(faults) & set(listed(where)):
            chosen += suites
    return chosen


def all_put_in(names: list[str]) -> dict[str, Caught]:
    with ThreadPoolExecutor(JOBS) as pool:
        return dict(zip(names, pool.map(put_in, names), strict=True))


def run(findings: Findings, size: Size) -> None:
    if size is not Size.FULL:
        _before_suites(findings, list(listed())[:: size.of(EVERY)])
        return
    build()
    all_caught = all_put_in(["", *listed()])
    without = all_caught.pop("")
    missed = [name for name, caught in all_caught.items() if not caught]
    by_judge = sum(bool(c.judges) for c in all_caught.values())
    by_test = sum(bool(c.tests) for c in all_caught.values())
    by_routes = sum(bool(c.routes) for c in all_caught.values())
    findings.figures |= {
        "pairs before the judges": PAIRS,
        "faults": {name: vars(caught) for name, caught in all_caught.items()},
        "alarms without a fault": vars(without),
    }
    findings.law("alarms without a fault", not without, "none", "none" if not without else without)
    for where, fewest in FEWEST_OF_LIST.items():
        count = len(listed(where))
        findings.law(f"faults in {where}", count >= fewest, f"at least {fewest}", count)
    findings.law("not caught", not missed, "none", ", ".join(missed) or "none")
    findings.target("caught by a judge", by_judge >= FEWEST, f"at least {FEWEST}", by_judge)
    findings.target("caught by a law or test", by_test >= FEWEST, f"at least {FEWEST}", by_test)
    findings.target("seen by our own routes", by_routes > 0, "some", by_routes)
    rows = {name: row(name, caught) for name, caught in all_caught.items()}
    TABLE.write_text(table(rows), encoding="utf-8")


def _before_suites(findings: Findings, names: list[str]) -> None:
    """Runs only the C++ laws, which need a tenth of the build."""
    build(*map(program, EVERY_SUITE))
    findings.none("alarms without a fault", laws("", EVERY_SUITE))
    in_plane = listed("plane")
    with ThreadPoolExecutor(JOBS) as pool:
        of = lambda name: laws(name, SUITES if name in in_plane else _suites([name]))  # noqa: E731
        caught = dict(zip(names, pool.map(of, names), strict=True))
    findings.figures["faults"] = caught
    findings.target("caught by a law", all(caught.values()), len(caught),
                    sum(map(bool, caught.values())))  # fmt: skip


def row(name: str, caught: Caught) -> str:
    columns = [caught.judges, caught.routes, caught.tests]
    if name not in listed("plane"):
        columns = [caught.tests]
    cells = [f"`{name}`", listed()[name], *(", ".join(names) for names in columns)]
    return "| " + " | ".join(cell or "-" for cell in cells) + " |"


def rows_of_table() -> dict[str, str]:
    """The table's current rows, by fault."""
    lines = TABLE.read_text(encoding="utf-8").splitlines()
    return {line.split("`")[1]: line for line in lines if line.startswith("| `")}


def table(rows: dict[str, str]) -> str:
    lines = [
        "# Faults put into the reference",
        "",
        "Made by `make evidence ONLY=planted_faults`: each fault of `tests/planted/`, put in "
        "alone, and what caught it. *Judges*: of `minkref verify minkref`, with the number of "
        f"the {PAIRS} random pairs, and of cases made from them, on which they saw it; a run ends "
        "where the reference itself gives up. *Routes*: routes of the reference refuted on the "
        "same pairs. *Laws and tests*: the first of each suite that fails.",
        "",
        "| fault | what is wrong | judges | routes | laws and tests |",
        "|---|---|---|---|---|",
        *(rows[name] for name in listed("plane")),
        "",
        "Faults in the code of sums in space, and in the doubles with bounds under it. They are "
        f"put before the C++ suites {', '.join(f'`{suite}`' for suite in SPACE_SUITES)} only.",
        "",
        "| fault | what is wrong | laws and tests |",
        "|---|---|---|",
        *(rows[name] for name in listed("space")),
        "",
        "Faults in the code of sums with a disc, put before the C++ suite `disc` only.",
        "",
        "| fault | what is wrong | laws and tests |",
        "|---|---|---|",
        *(rows[name] for name in listed("disc")),
    ]
    return "\n".join(lines) + "\n"


def main(names: list[str]) -> int:
    rows = rows_of_table()
    names = names or [name for name in listed() if name not in rows]
    if unknown := [name for name in names if name not in listed()]:
        print(f"no such fault: {', '.join(unknown)}", file=sys.stderr)
        return 2
    in_plane = bool(set(names) & set(listed("plane")))
    suites = _suites(names)
    build(*([] if in_plane else map(program, suites)))
    without = put_in("") if in_plane else laws("", suites)
    if without:
        print(f"alarms without a fault: {without}", file=sys.stderr)
        return 1
    all_caught = all_put_in(names)
    rows |= {name: row(name, caught) for name, caught in all_caught.items()}
    TABLE.write_text(table(rows), encoding="utf-8")
    return 0 if all(all_caught.values()) else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
