"""Radii at which two offset features start or stop to share points: right, and what the Appendix as
printed makes of them."""

from __future__ import annotations

from typing import Any

from minkref import _core
from minkref.fuzz.judges.disc_pair_comparison import SENTENCES, compare, compare_printed
from minkref.fuzz.judges.disc_pair_draws import KINDS
from minkref.fuzz.judges.disc_pair_polygons import compare_polygons
from minkref.reports.evidence.framework.operands import operand, tell_absent
from minkref.reports.evidence.framework.part import COMPARISON, MODELS, READERS, REFERENCE, Findings

SUBJECT = (
    "Pair events of a disc: two offset edges or arcs start or stop to share points. Of random "
    "pairs and polygons they are those of the symbolic oracle, and printed ones those of the "
    "Appendix's formulas; what each of its sentences misses and invents; counts and seconds of "
    "large polygons on one core."
)
MINUTES = (2, 0.1)
DEPENDS = (*REFERENCE, *READERS, *MODELS, *COMPARISON, "oracle/symbolic/*")

SEED = 1912
PAIRS, QUICK_PAIRS = 3000, 300  # of each kind
POLYGONS, QUICK_POLYGONS = 300, 20
COUNTED = ("neuron", "monkey", "bird")
READ = ("monkey", "bird")  # with each sentence as printed
QUICK = "bird"


def run(findings: Findings, quick: bool) -> None:
    _judge(findings, quick)
    names = (QUICK,) if quick else COUNTED
    tell_absent(findings, *names)
    findings.figures["models"] = [_of_model(findings, name, quick) for name in names]


def _judge(findings: Findings, quick: bool) -> None:
    pairs = QUICK_PAIRS if quick else PAIRS
    tables = {"corrected": compare(SEED, pairs), "printed": compare_printed(SEED, pairs)}
    for form, table in tables.items():
        findings.none(f"random pairs, {form}: differences from the oracle", table.differences)
        seen = min(table.pairs[kind] for kind in KINDS)
        findings.law(f"random pairs, {form}: of each kind", seen >= pairs, pairs, seen)
        special = sum(n for relation, n in table.relations.items() if relation != "free")
        told = ", ".join(f"{name} {n:,}" for name, n in sorted(table.contacts.items()))
        changes = ", ".join(f"{name} {n:,}" for name, n in sorted(table.changes.items()))
        findings.note(
            f"{form}: {sum(table.pairs.values()):,} random pairs of features, {special:,} of them "
            f"in a special position (seed {SEED}); contacts: {told}; events: {changes}"
        )
        findings.figures[form] = {
            "pairs": dict(table.pairs), "relations": dict(table.relations),
            "contacts": dict(table.contacts), "changes": dict(table.changes),
        }  # fmt: skip
    polygons = compare_polygons(SEED, QUICK_POLYGONS if quick else POLYGONS)
    findings.none("random polygons: differences from the oracle", polygons.differences)
    findings.note(
        f"{polygons.polygons:,} random polygons with {sum(polygons.events.values()):,} events"
    )


def _of_model(findings: Findings, name: str, quick: bool) -> dict[str, Any]:
    P = operand(name)
    found = _core.disc_pair_events(P.set)
    counts = dict(found.counts())
    findings.law(
        f"{P.name}: all kept, and each of them changes something",
        len(found) == counts["count"] == counts["right_count"] and "none" not in counts["changes"],
        f"{counts['count']:,}", f"{counts['right_count']:,}",
    )  # fmt: skip
    changes = ", ".join(f"{change} {n:,}" for change, n in counts["changes"].items())
    findings.note(
        f"{P.name} ({P.set.vertices:,} vertices): {counts['features']:,} features, "
        f"{counts['pairs']:,} pairs, {counts['count']:,} events ({changes}); "
        f"{counts['exact_signs']:,} signs by roots; {found.seconds:.1f} s on one core"
    )
    printed = _as_printed(findings, P) if quick or name in READ else []
    return {"model": P.name, **counts, "seconds": found.seconds, "printed": printed}


def _as_printed(findings: Findings, P: Any) -> list[dict[str, Any]]:
    """Each sentence that does not hold alone, then all; a disc of the radius 2 at the scale 1."""
    rows = []
    for sentences in (*([each] for each in SENTENCES), SENTENCES):
        counts = dict(_core.disc_pair_events(P.set, sentences, False, None, None, 0).counts())
        row = {
            "printed": sentences,
            "events": counts["count"],
            "missed": counts["true_count"] - counts["right_count"],
            "invented": counts["count"] - counts["right_count"],
        }
        rows.append(row)
        what = sentences[0] if len(sentences) == 1 else "all sentences"
        findings.note(
            f"{P.name}, printed: {what}: misses {row['missed']:,} of {counts['true_count']:,} "
            f"events, invents {row['invented']:,}"
        )
    return rows
