"""The route `definition` (sums of all pairs of triangles) against `paper`."""

from __future__ import annotations

from minkref import _core
from minkref.exact import digest
from minkref.fuzz.plane.case import Case
from minkref.model_catalogue import shipped_models
from minkref.reports.evidence.framework.operands import case_of, operand, tell_absent
from minkref.reports.evidence.framework.part import MODELS, READERS, REFERENCE, Findings

SUBJECT = (
    "The sum from the definition: all ordered pairs of shipped models with at most 100 x 30 pairs "
    "of vertices, and neuron + disc1; one digest with route paper."
)
MINUTES = (0.5, 0.2)
DEPENDS = (*REFERENCE, *READERS, *MODELS)

MOST_PAIRS = 100 * 30
SCALES = ("1", "7/5")


def small_pairs(most: int) -> list[tuple[str, str]]:
    """Ordered pairs of shipped models of at most `most` pairs of vertices."""
    sizes = {model.name: operand(model.name).set.vertices for model in shipped_models()}
    return [(a, b) for a in sizes for b in sizes if sizes[a] * sizes[b] <= most]


def both(case: Case) -> tuple[str, str, float]:
    """Digests by paper and by definition, and the seconds of the latter."""
    paper = _core.minkowski_sum(case.P, case.Q, case.scale, "paper")
    other = _core.minkowski_sum(case.P, case.Q, case.scale, "definition")
    texts = paper.region.canonical_json(), other.region.canonical_json()
    return digest(texts[0]), digest(texts[1]), other.seconds


def run(findings: Findings, quick: bool) -> None:
    tell_absent(findings, "neuron")
    pairs = small_pairs(1100 if quick else MOST_PAIRS)
    cases = [case_of(a, b, scale) for a, b in pairs for scale in (SCALES[:1] if quick else SCALES)]
    cases.append(case_of("disc1", "neuron", "1"))
    agreed, rows, seconds = 0, [], 0.0
    for case in cases:
        first, second, took = both(case)
        agreed += first == second
        seconds += took
        rows.append({"case": case.name.text, "same": first == second, "seconds": round(took, 3)})
        print(rows[-1], flush=True)
    findings.figures = {"cases": len(cases), "seconds": round(seconds, 1), "rows": rows}
    findings.equal("cases with one digest", len(cases), agreed)
    findings.target("pairs of shipped models", len(pairs) >= 10, "at least 10", len(pairs))
