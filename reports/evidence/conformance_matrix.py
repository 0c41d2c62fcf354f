"""All targets that can be installed, in one run: the matrix and the shrunk findings."""

from __future__ import annotations

from minkref.fuzz.libraries import catalogue
from minkref.fuzz.targets.catalogue import list_targets
from minkref.reports.evidence.framework.command import counts_of, told, verify
from minkref.reports.evidence.framework.part import CGAL, COMPARISON, READERS, REFERENCE, Findings
from minkref.reports.evidence.framework.store import FOLDER

SUBJECT = (
    "All targets, those of other libraries installed, for 600 s on two cores: the matrix, and the "
    "findings of each shrunk to a handful of vertices, known faults among them, found by search."
)
MINUTES = (25, 0.3)
DEPENDS = (*REFERENCE, *READERS, *CGAL, *COMPARISON, "fuzz/adapters/*", "fuzz/libraries/*/*")

SEED = 6
SECONDS, QUICK_SECONDS = 600, 8
FEW_VERTICES = 16
# Target: a kind of fault that its version here is known to have, and where that is reported.
KNOWN = {
    "cgal-reduced": ("hole-lost", "5.5.", "CGAL issue 5830"),
    "cgal-full": ("crashed", "5.5.", "CGAL issue 8551"),
    "manifold3d": ("extra", "3.5.4", "a copy of the first operand is united into the result"),
    "pysfcgal": ("hole-lost", "2.3.0", "holes of the second operand are dropped"),
}
RAW = ("cgal-reduced-raw", "cgal-vertical-raw")  # these alone show CGAL issue 5839
OURS = ("minkref:", "minkref-")


def run(findings: Findings, quick: bool) -> None:
    for name in catalogue.ADAPTERS:
        if catalogue.absence(name) is not None and not quick:
            catalogue.install(name)
    absent = [entry for entry in list_targets() if not entry.available]
    findings.law("targets that are absent", not absent or quick, 0, len(absent))
    for entry in absent:
        findings.note(f"{entry.name} is absent: {entry.reason}")
    seconds = QUICK_SECONDS if quick else SECONDS
    report = FOLDER / "conformance"
    words = ["all", *RAW, "--seconds", seconds, "--seed", SEED, "--jobs", 2, "--report", report]
    words += ["--shrink-calls", 60 if quick else 400, "--no-models"]
    code, value = verify(*words, seconds=seconds)
    findings.figures["exit code"] = code
    for target in value["targets"]:
        title = f"{target['name']} {target['version'] or ''}".strip()
        findings.figures[title] = told(counts_of(value, target["name"]))
    ours = [
        finding
        for finding in value["findings"]
        if finding["target"].startswith(OURS[0]) and finding["verdict"] != "undecided"
    ]
    findings.none("findings against the exact routes of the reference", len(ours))
    if not quick:  # there is no time to find them
        _known(findings, value)
    for row in value["shrunk"]:
        kinds = " ".join(row["reasons"]) or row["verdict"]
        found = f"{row['target']} {kinds}: {row['count']} found; {row['reproduce']}"
        findings.note(found if len(found) < 900 else found[:897] + "...")


def _known(findings: Findings, value: dict[str, object]) -> None:
    versions = {row["name"]: row["version"] or "" for row in value["targets"]}  # type: ignore[attr-defined]
    for target, (kind, version, where) in KNOWN.items():
        if not str(versions.get(target, "")).startswith(version):
            findings.note(f"{target} is not {version}: {where} is not looked for")
            continue
        rows = [
            row
            for row in value["shrunk"]  # type: ignore[attr-defined]
            if row["target"] == target and kind in (*row["reasons"], row["verdict"], row["was"])
        ]
        least = min((_vertices(row) for row in rows), default=0)
        what = f"{target} {kind} ({where}), shrunk, vertices"
        met = bool(rows) and least <= FEW_VERTICES
        findings.law(what, met, f"at most {FEW_VERTICES}", least or "not found")


def _vertices(row: dict[str, object]) -> int:
    count = 0
    for name in ("P", "Q"):
        value = row[name]["set"] or {}  # type: ignore[index]
        count += len(value.get("vertices", ()))
        for polygon in value.get("polygons", ()):
            count += sum(len(ring) for ring in (polygon["outer"], *polygon.get("holes", ())))
    return count
