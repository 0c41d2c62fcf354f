"""Certificates of paths and traps, before both checkers."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.certify.motion.path_certificate import PathCertificate
from minkref.certify.plane.certificate import NoProof
from minkref.reports.evidence.certificates.checkers import in_cpp, in_python, timed, verdicts

#: Figures for a set of certificates: their number, and the worst size and time of each kind.
Figures = dict[str, float]


@dataclass(frozen=True)
class Made:
    """A certificate; None without a proof (`why`)."""

    name: str
    certificate: PathCertificate | None
    why: str
    seconds: float


def made(
    name: str,
    sets: tuple[_core.PolygonSet, _core.PolygonSet],
    path: Sequence[Any],
    claim: Callable[[PathCertificate], int],
) -> Made:
    began = time.perf_counter()
    certificate = PathCertificate(*sets, path)
    try:
        claim(certificate)
    except NoProof as error:
        return Made(name, None, str(error), time.perf_counter() - began)
    return Made(name, certificate, "", time.perf_counter() - began)


def faults(several: Sequence[Made]) -> list[str]:
    """Certificates that a checker does not verify."""
    with tempfile.TemporaryDirectory() as folder:
        files = {one.name: written(one, Path(folder), str(k)) for k, one in enumerate(several)}
        return [
            f"{name}: {command[-1]}: {verdict.why}"
            for command in (in_python(), in_cpp())
            for name, verdict in zip(files, verdicts(command, list(files.values())), strict=True)
            if verdict.code != 0
        ]


def figures(several: Sequence[Made]) -> Figures:
    """How many, the largest, the slowest to make."""
    if not several:
        return {"certificates": 0, "largest bytes": 0, "longest to make, s": 0}
    texts = [one.certificate.text("it") for one in several if one.certificate is not None]
    return {
        "certificates": len(several),
        "largest bytes": max(len(text.encode()) for text in texts),
        "longest to make, s": round(max(one.seconds for one in several), 3),
    }


def joined(first: Figures, second: Figures) -> Figures:
    """Merges the figures for two sets of certificates."""
    return {
        name: value + second[name] if name == "certificates" else max(value, second[name])
        for name, value in first.items()
    }


def checking_seconds(one: Made) -> dict[str, float]:
    """Processor seconds for both checkers, each with its start."""
    with tempfile.TemporaryDirectory() as folder:
        file = written(one, Path(folder), "it")
        return {
            "check.py, s": round(timed(in_python(), file)[1], 3),
            "minkref-check, s": round(timed(in_cpp(), file)[1], 3),
        }


def written(one: Made, folder: Path, stem: str) -> Path:
    """Writes the certificate with its case beside it."""
    assert one.certificate is not None
    (folder / f"{stem}.case.json").write_text(one.certificate.case(), encoding="utf-8")
    file = folder / f"{stem}.cert.json"
    file.write_text(one.certificate.text(f"{stem}.case.json"), encoding="utf-8")
    return file
