"""Runs all targets at once, including other libraries and CGAL's raw methods: no false alarm, and
search finds known faults and shrinks them to a handful of vertices."""

from __future__ import annotations

from typing import Any

from minkref.fuzz.all_targets import ALL_TARGETS
from minkref.fuzz.judges.witness_check import confirmed
from minkref.fuzz.libraries import catalogue
from minkref.fuzz.plane.judgement import TRUTHS
from minkref.reports.evidence.framework.command import counts_of, told, verify
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.framework.places import FOLDER

RESTS_ON = ("fuzz/adapters/", "fuzz/libraries/")
MINUTES = Minutes(0.2, 2, 30)

SEED = 2024
SECONDS = Counts(4, 75, 1200)
SHRINK_CALLS = Counts(10, 100, 400)
FEW_VERTICES = 16
# Target: a fault known in its version here, that version, and the report.
KNOWN = {
    "cgal-reduced": ("hole-lost", "5.5.", "CGAL issue 5830"),
    "cgal-full": ("crashed", "5.5.", "CGAL issue 8551"),
    "manifold3d": ("extra", "3.5.4", "a copy of the first operand is united into the result"),
    "pysfcgal": ("hole-lost", "2.3.0", "holes of the second operand are dropped"),
}
# Only these targets show CGAL issue 5839.
RAW = tuple(f"cgal-{method}-raw" for method in ("reduced", "vertical", "triangulation"))


def run(findings: Findings, size: Size) -> None:
    for name in catalogue.ADAPTERS:
        if catalogue.absence(name) is not None and size is Size.FULL:
            catalogue.install(name)
    absent = [entry for entry in ALL_TARGETS.entries() if not entry.available]
    findings.law("targets that are absent", not absent or size is not Size.FULL, 0, len(absent))
    for entry in absent:
        findings.note(f"{entry.name} is absent: {entry.reason}")
    seconds = size.of(SECONDS)
    words = ["all", *RAW, "--seconds", seconds, "--seed", SEED, "--jobs", 2, "--no-models"]
    words += ["--report", FOLDER / "conformance", "--shrink-calls", size.of(SHRINK_CALLS)]
    code, value = verify(*words, seconds=seconds)
    findings.figures["exit code"] = code
    for target in value["targets"]:
        title = f"{target['name']} {target['version'] or ''}".strip()
        findings.figures[title] = told(counts_of(value, target["name"]))
    _confirmed(findings, value)
    ours = [finding for finding in value["findings"] if finding["target"].startswith("minkref:")]
    findings.none("findings against the exact routes of the reference", len(ours))
    undecided = sum(
        counts_of(value, target["name"]).get("undecided", 0)
        for target in value["targets"]
        if target["name"] in TRUTHS or target["name"].startswith("cgal-")
    )
    findings.none("undecided, of our routes and CGAL's", undecided)
    if size is Size.FULL:  # shorter runs may not find them
        _known(findings, value)
    for row in value["shrunk"]:
        kinds = " ".join(row["reasons"]) or row["verdict"]
        found = f"{row['target']} {kinds}: {row['count']} found; {row['reproduce']}"
        findings.note(found if len(found) < 900 else found[:897] + "...")


def _confirmed(findings: Findings, value: dict[str, Any]) -> None:
    """Confirms every `wrong` plane result again, with the slow engine."""
    wrong = [
        finding
        for finding in value["findings"]
        if finding["verdict"] == "wrong" and "polygons" in (finding["P"]["set"] or {})
        and (finding["witness"] or finding["target"].startswith("cgal-"))
    ]  # fmt: skip
    refuted = [finding for finding in wrong if not confirmed(finding)]
    findings.none(f"of {len(wrong)} witnesses, refuted by the slow engine", len(refuted))
    for finding in refuted:
        findings.note(f"{finding['target']}: {finding['reproduce']}")


def _known(findings: Findings, value: dict[str, Any]) -> None:
    versions = {row["name"]: row["version"] or "" for row in value["targets"]}
    for target, (kind, version, where) in KNOWN.items():
        if not str(versions.get(target, "")).startswith(version):
            findings.note(f"{target} is not {version}: {where} is not looked for")
            continue
        rows = [
            row
            for row in value["shrunk"]
            if row["target"] == target and kind in (*row["reasons"], row["verdict"], row["was"])
        ]
        least = min((_vertices(row) for row in rows), default=0)
        what = f"{target} {kind} ({where}), shrunk, vertices"
        met = bool(rows) and least <= FEW_VERTICES
        findings.law(what, met, f"at most {FEW_VERTICES}", least or "not found")


def _vertices(row: dict[str, Any]) -> int:
    count = 0
    for name in ("P", "Q"):
        value = row[name]["set"] or {}
        count += len(value.get("vertices", ()))
        for polygon in value.get("polygons", ()):
            count += sum(len(ring) for ring in (polygon["outer"], *polygon.get("holes", ())))
    return count
