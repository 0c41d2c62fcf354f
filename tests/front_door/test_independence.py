"""The include check, which `make lint` runs, finds every way to break the rule of independence."""

from __future__ import annotations

import importlib.util
from pathlib import Path
from typing import Any

import pytest


def _check() -> Any:
    path = Path(__file__).resolve().parents[2] / "tools" / "scripts" / "check_includes.py"
    spec = importlib.util.spec_from_file_location("check_includes", path)
    assert spec and spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


CHECK = _check()


@pytest.mark.parametrize(
    ("file", "line"),
    [
        ("reference/plane/sum.cpp", "#include <CGAL/minkowski_sum_2.h>"),
        ("reference/plane/sum.cpp", "#include <nlohmann/json.hpp>"),
        ("reference/plane/sum.cpp", '#include "formats/read.hpp"'),
        ("reference/plane/sum.hpp", '  #  include "../../formats/read.hpp"'),
        ("reference/plane/index/slice.cpp", '#include "reference/plane/dynamic/dynamic_sum.hpp"'),
        ("reference/plane/moving/track.hpp", '#include "reference/plane/critical/moments.hpp"'),
        ("reference/plane/sum.cpp", '#include "reference/space/polyhedron.hpp"'),
        ("reference/plane/sum.cpp", '#include "reference/paper/trials/filter_trial.hpp"'),
        ("formats/read.cpp", "#include <CGAL/Polygon_2.h>"),
        ("oracle/cgal/full.cpp", '#include "reference/plane/sum.hpp"'),
        ("oracle/cgal/full.cpp", '#include "formats/read.hpp"'),
        ("formats/read.cpp", '#include "oracle/cgal/polygon.hpp"'),
        ("bindings/core.cpp", '#include "oracle/cgal/polygon.hpp"'),
        ("tests/plane/sum.cpp", '#include "oracle/cgal/polygon.hpp"'),
        ("tests/plane/sum.cpp", "#include <CGAL/Polygon_2.h>"),
        ("oracle/slow/sum.py", "from minkref.fuzz.cases import case"),
        ("oracle/slow/sum.py", "import minkref"),
        ("oracle/slow/sum.py", "def f():\n    import gmpy2"),
        ("fuzz/run/runner.py", "from oracle.slow import sum"),
        ("oracle/symbolic/pairs.py", "from ..slow import minkowski_sum"),
        ("oracle/symbolic/pairs.py", "from .. import slow"),
        ("oracle/symbolic/space/facet_pairs.py", "from ...slow import exact"),
        ("oracle/symbolic/pairs.py", 'import_module("minkref._core")'),
        ("oracle/symbolic/pairs.py", 'import_module("..slow", __package__)'),
        ("minkref/api.py", "from minkref.oracle import slow"),
        ("reports/evidence/run.py", "import minkref.oracle.slow"),
        ("reference/CMakeLists.txt", "find_package(CGAL)"),
        ("minkref/api.py", "from minkref.cli import cli"),
        ("minkref/api.py", "def f():\n    from minkref import fuzz"),
        ("certify/plane/certificate.py", "import minkref.degeneracies.plane.draft"),
        ("fuzz/run/runner.py", "from minkref.reports import pages"),
        ("reports/conformance/page.py", 'import_module("minkref.verbs.verify")'),
        ("reports/conformance/page.py", 'importlib.import_module(f"minkref.verbs.{name}")'),
        ("reports/pages.py", "from minkref.reports.evidence import run"),
    ],
)
def test_a_broken_rule_is_named_with_its_file_and_line(
    tmp_path: Path, file: str, line: str
) -> None:
    path = tmp_path / file
    path.parent.mkdir(parents=True)
    path.write_text(f"\n{line}\n", encoding="utf-8")
    (fault, *_) = CHECK.faults(tmp_path)
    assert str(fault).startswith(f"{file}:{2 + line.count(chr(10))}: ")


@pytest.mark.parametrize(
    ("file", "line"),
    [
        ("reference/plane/sum.cpp", '#include "reference/error.hpp"'),
        ("reference/plane/sum.cpp", "#include <Eigen/Core>"),
        ("formats/read.cpp", "#include <nlohmann/json.hpp>"),
        ("oracle/cgal/full.cpp", "#include <CGAL/minkowski_sum_2.h>"),
        ("oracle/slow/sum.py", "from fractions import Fraction"),
        ("oracle/slow/space/solid.py", "from ..exact import number"),
        ("oracle/slow/sum.py", "from oracle.slow.rings import area"),
        ("fuzz/judges/sums.py", "from minkref.oracle import slow"),
        ("oracle/symbolic/pairs.py", 'import_module(f".{name}", __package__)'),
        ("reference/CMakeLists.txt", "# never CGAL"),
        ("minkref/__main__.py", "from minkref.cli.cli import main"),
        ("minkref/verbs/report.py", 'import_module(f"minkref.reports.{name}")'),
        ("reports/evidence/view_page.py", "from minkref.plane.page import picture"),
    ],
)
def test_what_the_rule_allows_passes(tmp_path: Path, file: str, line: str) -> None:
    path = tmp_path / file
    path.parent.mkdir(parents=True)
    path.write_text(line + "\n", encoding="utf-8")
    assert not CHECK.faults(tmp_path)
