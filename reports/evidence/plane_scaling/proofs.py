"""Certificates of sums with a factor for each axis, before all checkers; forged ones too."""

from __future__ import annotations

import json
import tempfile
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.certify.plane.certificate import Certificate
from minkref.fuzz.plane.case import Case
from minkref.reports.evidence.certificates.certified_cases import SMALL, written
from minkref.reports.evidence.certificates.checkers import in_cpp, in_proved, in_python, verdicts
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.plane_scaling.scaled_pairs import SEED, scaled_pairs

MINUTES = Minutes(0.2, 2, 5)

SUMS = Counts(10, 100, 400)
DRAWN = 4  # pairs drawn for each that is small enough


def run(findings: Findings, size: Size) -> None:
    checkers = {"check.py": in_python(), "minkref-check": in_cpp()}
    try:
        checkers["minkref-check-proved"] = in_proved()
    except FileNotFoundError as error:
        findings.target("minkref-check-proved is built", False, "built", str(error))
    chosen = [
        case
        for case in scaled_pairs(DRAWN * size.of(SUMS))
        if case.P.vertices + case.Q.vertices <= SMALL
    ][: size.of(SUMS)]
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        _true(findings, checkers, chosen, folder)
        _forged(findings, checkers, chosen, folder)


def certified(case: Case) -> Certificate:
    certificate = Certificate(case.P, case.Q, case.scale.split(","))
    certificate.sum(1, passages=True)
    return certificate


def _true(
    findings: Findings, checkers: dict[str, list[str]], cases: list[Case], folder: Path
) -> None:
    files = [written(certified(case), folder, f"true{k}") for k, case in enumerate(cases)]
    for name, command in checkers.items():
        found = [verdict.code for verdict in verdicts(command, files)]
        findings.equal(f"certificates verified by {name}", len(files), found.count(0))
    findings.figures |= {"seed": SEED, "certificates": len(files)}


def _forged(
    findings: Findings, checkers: dict[str, list[str]], cases: list[Case], folder: Path
) -> None:
    """Forgeries with a wrong sum, according to the reference; every checker refuses them."""
    files: list[Path] = []
    kinds: Counter[str] = Counter()
    for k, case in enumerate(cases):
        text = json.loads(certified(case).text(f"forged{k}.case.json"))
        (folder / f"forged{k}.case.json").write_text(certified(case).case(), encoding="utf-8")
        for kind, forge in FORGERIES.items():
            value = forge(json.loads(json.dumps(text)))
            if _is_true(case, value):
                continue
            path = folder / f"forged{k}.{kind.replace(' ', '-')}.cert.json"
            path.write_text(json.dumps(value), encoding="utf-8")
            files.append(path)
            kinds[kind] += 1
    findings.figures["forgeries"] = dict(kinds)
    for name, command in checkers.items():
        codes = Counter(verdict.code for verdict in verdicts(command, files))
        findings.none(f"forgeries that {name} verifies", codes[0])
        findings.equal(f"forgeries that {name} refuses", len(files), codes[1] + codes[2])


def _is_true(case: Case, value: dict[str, Any]) -> bool:
    """Whether the forgery claims a right sum after all, as of symmetric operands."""
    if (value["certificate"] == "axes-certificate-v1") != ("axes" in value):
        return False  # neither form
    axes = value.get("axes", ["1", "1"])
    if len(axes) != 2 or not all(isinstance(f, str) and not f.startswith("-") for f in axes):
        return False
    sums = (_core.minkowski_sum(case.P, case.Q, s) for s in (case.scale, ",".join(axes)))
    ours = [found.region for found in sums]
    return ours[0] == ours[1]


def _with(**members: Any) -> Callable[[dict[str, Any]], dict[str, Any]]:
    return lambda value: {**value, **members}


def _changed(axis: int) -> Callable[[dict[str, Any]], dict[str, Any]]:
    def forge(value: dict[str, Any]) -> dict[str, Any]:
        value["axes"][axis] = f"{value['axes'][axis]}1" if "/" in value["axes"][axis] else "11/7"
        return value

    return forge


def _exchanged(value: dict[str, Any]) -> dict[str, Any]:
    value["axes"].reverse()
    return value


def _without(value: dict[str, Any]) -> dict[str, Any]:
    del value["axes"]
    return value


def _plain(value: dict[str, Any]) -> dict[str, Any]:
    return {**_without(value), "certificate": "certificate-v1"}


FORGERIES: dict[str, Callable[[dict[str, Any]], dict[str, Any]]] = {
    "x changed": _changed(0),
    "y changed": _changed(1),
    "axes exchanged": _exchanged,
    "axes left out": _without,
    "another form": _plain,
    "axes of the old form": _with(certificate="certificate-v1"),
    "three axes": _with(axes=["1", "2", "3"]),
    "a negative axis": _with(axes=["-1", "2"]),
}
