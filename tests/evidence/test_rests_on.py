"""Files that a result rests on: files read by its processes, or C++ code beneath; and stale
rows."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

pytest.importorskip("minkref._core", reason="the extension module is not built")

from minkref import _core
from minkref.fuzz.judges.disc.offset_cgal import absence
from minkref.reports.evidence.framework import child, includes, places, recorded, stale, store
from minkref.reports.evidence.framework.part import Size
from minkref.reports.evidence.framework.steps import steps

BINDING = """
#include "reference/disc/offset.hpp"
  module.def("offset", &offset, "P"_a);
  nb::class_<Offset> bound(module, "Offset");
  bound.def("sum", &Offset::sum, "radius"_a);
"""
FILES = {
    "CMakeLists.txt": "",
    "tools/cmake/MinkrefBuild.cmake": "",
    "bindings/core.cpp": '#include "bindings/core.hpp"',
    "bindings/core.hpp": "",
    "bindings/core_disc.cpp": BINDING,
    "bindings/core_sum.cpp": '#include "reference/sum.hpp"\n module.def("sum", &sum);',
    "reference/sum.hpp": "",
    "reference/sum.cpp": '#include "reference/sum.hpp"\n#include "reference/number.hpp"',
    "reference/number.hpp": "",
    "reference/disc/offset.hpp": '#pragma once\n#include "arc.hpp"',
    "reference/disc/arc.hpp": "// #include of nothing",
    "reference/disc/measures.cpp": '#include "reference/disc/arc.hpp"',
    "oracle/judge/main.cpp": '#include "oracle/judge/part.hpp"',
    "oracle/judge/part.hpp": "",
    "oracle/judge/CMakeLists.txt": "",
    "plane.py": "from minkref import _core\n_core.sum(1).offset",
    "disc.py": "from minkref._core import (\n    Offset,\n)",
    "quoted.py": 'getattr(_core, "sum")',
    "pure.py": 'core.offset("sum")',
}
BUILD = {
    "CMakeLists.txt",
    "tools/cmake/MinkrefBuild.cmake",
    "bindings/core.cpp",
    "bindings/core.hpp",
}
SUM = {"bindings/core_sum.cpp", "reference/sum.hpp", "reference/sum.cpp", "reference/number.hpp"}
DISC = {"bindings/core_disc.cpp", *(name for name in FILES if name.startswith("reference/disc"))}
JUDGE = {name for name in FILES if name.startswith("oracle")}


@pytest.fixture
def root(tmp_path: Path) -> Path:
    for name, text in FILES.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    return tmp_path


@pytest.mark.parametrize(
    ("read", "reached"),
    [
        ({"plane.py"}, BUILD | SUM),  # a method of another class has the name of a function
        ({"disc.py"}, BUILD | DISC),
        ({"quoted.py"}, BUILD | SUM),
        ({"pure.py"}, set()),
        ({"plane.py", "disc.py"}, BUILD | SUM | DISC),
        ({"oracle/judge/"}, JUDGE),
        ({"reference/sum.hpp"}, set()),  # as text
    ],
)
def test_from_what_python_names_to_what_is_included(
    root: Path, read: set[str], reached: set[str]
) -> None:
    named = {name for name in read if not name.endswith("/")}
    assert includes.reached(read, root) == reached | named


def test_every_name_of_the_module_is_found_where_it_is_defined() -> None:
    names = {name for name in dir(_core) if not name.startswith("__")}
    found = includes.bindings(places.ROOT)
    assert names <= set(found) and all(hasattr(_core, name) for name in found)
    assert {path.name for path in found["minkowski_sum"]} == {"core_sum.cpp"}
    assert {path.name for path in found["offset"]} == {"core_disc.cpp"}


def test_no_source_of_the_reference_is_out_of_reach() -> None:
    every = includes.closure((places.ROOT / "bindings").glob("*.cpp"), places.ROOT)
    sources = {path for path in (places.ROOT / "reference").rglob("*.cpp")}
    apart = {path.name for path in sources - every}
    assert len(apart) <= 3, apart


READS = """
import subprocess, sys
from multiprocessing import get_context
from minkref.exact import digest
def work(name):
    return len(open(name).read())
if __name__ == "__main__":
    for way in ("fork", "spawn"):
        with get_context(way).Pool(1) as pool:
            pool.map(work, [f"docs/{way}ed.md"])
    subprocess.run([sys.executable, "-m", "minkref", "families", "--help"], stdout=-3, check=True)
    subprocess.run([sys.executable, "-c", "open('README.md')"], env={}, check=True)
    subprocess.run(["true", "Makefile"], check=True)
    open("build/unread", "w").close()
"""


def test_all_processes_record_what_they_read_and_start(tmp_path: Path) -> None:
    """Records pools of both kinds, commands, and programs' input, except where an empty environment
    prevents it."""
    script = tmp_path / "reads.py"
    docs = [places.ROOT / "docs" / name for name in ("formats.md", "verify.md")]
    text = READS.replace("forked.md", docs[0].name).replace("spawned.md", docs[1].name)
    script.write_text(text.replace("{way}ed.md", "{dict(fork='formats', spawn='verify')[way]}.md")
                      .replace("build/unread", str(tmp_path / "unread")))  # fmt: skip
    to = tmp_path / "recorded"
    to.mkdir()
    subprocess.run(
        [sys.executable, script], cwd=places.ROOT, env=recorded.environment(to), check=True
    )
    names = {recorded.named(line, places.ROOT) for line in recorded.lines(to)}
    expected = {"docs/formats.md", "docs/verify.md", "minkref/exact.py", "Makefile"}
    assert expected | {"minkref/__main__.py", "minkref/cli/cli.py"} <= names
    assert "README.md" not in names


def test_a_process_that_cannot_record_goes_on(tmp_path: Path) -> None:
    code = "open('README.md').close(); print('done')"
    done = subprocess.run(
        [sys.executable, "-c", code], env=recorded.environment(tmp_path / "absent"),
        cwd=places.ROOT, capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert (done.stdout, done.stderr) == ("done\n", "")


@pytest.fixture(scope="module")
def rests_on(tmp_path_factory: pytest.TempPathFactory) -> dict[str, set[str]]:
    """Files used by two finished steps, one for the plane and one for a disc."""
    if absence():
        pytest.skip("CGAL's exact offset is not built")
    folder = tmp_path_factory.mktemp("results")
    found = {}
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(places, "FOLDER", folder)
        patch.setenv("MINKREF_EVIDENCE", str(folder))
        for step in steps():
            if step.name in ("plane_sums/scalar_types", "disc_events/radii"):
                document = child.run_in_child(step, Size.QUICK, lambda: None)
                assert document["status"] == "met", document
                assert document["commit"] or not os.path.isdir(places.ROOT / ".git")
                assert store.kept(step.name, Size.QUICK) == document
                found[step.part] = set(document["files"])
    return found


@pytest.mark.parametrize(
    ("file", "parts"),
    [
        ("reference/disc/index/none.hpp", []),  # a folder that is not used whole
        ("reference/disc/region/exact_pieces.hpp", ["disc_events"]),
        ("bindings/core_disc_events.cpp", ["disc_events"]),
        ("oracle/cgal/offset_service.cpp", ["disc_events"]),
        ("fuzz/judges/disc/offset_cgal.py", ["disc_events"]),
        ("reference/plane/polygon_set.cpp", ["disc_events", "plane_sums"]),
        ("minkref/plane/operand.py", ["disc_events", "plane_sums"]),
        ("minkref/models/g1.poly", ["disc_events", "plane_sums"]),
        ("reports/evidence/plane_sums/scalar_types.py", ["plane_sums"]),
        ("reports/evidence/run.py", []),
        ("minkref/disc/commands/disc_events.py", []),
        ("oracle/checker/main.cpp", []),
        ("reference/space/edges/edge_sum.cpp", []),
        ("docs/disc.md", []),
    ],
)
def test_a_change_makes_only_those_stale_that_rest_on_it(
    rests_on: dict[str, set[str]], file: str, parts: list[str], tmp_path: Path
) -> None:
    stale.write(tmp_path / "rests_on.json", rests_on)
    again = stale.read(tmp_path / "rests_on.json")
    assert again == rests_on
    assert stale.resting_on([file], again) == parts
