"""A checkout with the recipes of tests/recipes followed, built and asked."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import Any

from minkref.reports.evidence.framework.part import Findings, Minutes, Size
from minkref.reports.evidence.framework.places import ROOT
from minkref.reports.evidence.house.followed import PATCHES, environment, files_of, follow

MINUTES = Minutes(None, 10, 10)
RESTS_ON = (
    "CMakeLists.txt", "tools/cmake/", "bindings/", "formats/", "reference/", "certify/",
    "minkref/verbs/sum.py", "tests/recipes/",
)  # fmt: skip
CHECKOUT = ROOT / "build" / "recipes"
ROUTES = ("paper", "winding", "definition")
TETRAHEDRON = "0 0 0 0 1 0 1 0 0\n0 0 0 1 0 0 0 0 1\n0 0 0 0 0 1 0 1 0\n0 1 0 0 0 1 1 0 0\n"


def run(findings: Findings, size: Size) -> None:
    recipes = sorted(path.stem for path in PATCHES.glob("*.patch"))
    findings.figures["files touched"] = {name: len(files_of(name)) for name in recipes}
    follow(recipes, CHECKOUT)
    build = CHECKOUT / "build"
    python = ROOT / ".venv" / "bin" / "python"
    configured = [
        "cmake",
        "--preset",
        "release",
        "-DMINKREF_PYTHON=ON",
        f"-DPython_EXECUTABLE={python}",
    ]
    subprocess.run([*configured, "-B", build], cwd=CHECKOUT, check=True)
    subprocess.run(["cmake", "--build", build, "--target", "_core"], check=True)
    there = environment(CHECKOUT, build)

    def asked(*words: str) -> Any:
        command = [str(python), "-m", "minkref", "sum", *words, "--json"]
        done = subprocess.run(
            command, cwd=CHECKOUT, env=there, capture_output=True, text=True, check=True
        )
        return json.loads(done.stdout)

    digests = {asked("g1", "g2", "--route", route)["digest"] for route in (*ROUTES, "exchanged")}
    findings.equal("digests of a sum by all routes, the new one too", 1, len(digests))
    file = Path(CHECKOUT, "tetrahedron.tri")
    file.write_text(TETRAHEDRON, encoding="utf-8")
    doubled = asked(str(file), str(file), "-o", "doubled.tri")
    findings.equal(
        "volume of a tetrahedron of the new format, added to itself", "4/3", doubled["volume"]
    )
    lines = (CHECKOUT / "doubled.tri").read_text(encoding="utf-8").splitlines()
    findings.equal("triangles written", 4, len(lines))
