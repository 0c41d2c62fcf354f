"""Radii at which two offset features start or stop sharing points: the right answers, and the
answers from the Appendix as printed."""

from __future__ import annotations

from typing import Any

from minkref import _core
from minkref.fuzz.judges.disc.disc_pair_comparison import SENTENCES, compare, compare_printed
from minkref.fuzz.judges.disc.disc_pair_draws import KINDS
from minkref.fuzz.judges.disc.disc_pair_polygons import compare_polygons
from minkref.reports.evidence.framework.operands import operand, tell_absent
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.1, 1, 2)

SEED = 1912
PAIRS = Counts(60, 800, 3000)  # of each kind
POLYGONS = Counts(5, 80, 300)
COUNTED = ("neuron", "monkey", "bird")
READ = ("monkey", "bird")  # with each sentence as printed


def run(findings: Findings, size: Size) -> None:
    _judge(findings, size)
    names = COUNTED[-1:] if size is Size.QUICK else COUNTED
    tell_absent(findings, *names)
    findings.figures["models"] = [_of_model(findings, name, size) for name in names]


def _judge(findings: Findings, size: Size) -> None:
    pairs = size.of(PAIRS)
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
    polygons = compare_polygons(SEED, size.of(POLYGONS))
    findings.none("random polygons: differences from the oracle", polygons.differences)
    findings.note(
        f"{polygons.polygons:,} random polygons with {sum(polygons.events.values()):,} events"
    )


def _of_model(findings: Findings, name: str, size: Size) -> dict[str, Any]:
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
    printed = _as_printed(findings, P) if name in READ and size is not Size.QUICK else []
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
