"""Rows of a ledger: one for each case and target; back again as results of cases."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from itertools import groupby
from typing import Any

from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.run.ledger import plain_of, result_of
from minkref.fuzz.run.runner import verb_of
from minkref.fuzz.run.worker import CaseResult
from minkref.fuzz.verdicts.verdict import GOOD, Outcome, Reason, Verdict

NO_FAULT = (*GOOD, Verdict.SKIPPED)
LONGEST_MESSAGE = 500  # characters
UNTAKEN = "untaken: "  # begins the message of a row without target; else the case is absent


def rows_of(result: CaseResult, versions: Mapping[str, str | None]) -> Iterator[dict[str, Any]]:
    """The rows of a case: one for each outcome; a single one without target and verdict if the case
    does not exist, or no target takes it."""
    case = {
        "number": result.number,
        "case": result.name.text,
        "setting": "space" if result.dimension == 3 else "plane",
        "question": verb_of(result.name.text),
        "family": result.family or result.name.group,
        "class": result.name.group,
        "position": result.position,
        "flags": " ".join(sorted(result.needs)),
        "scale": result.scale,
        "coverage": result.coverage,
        "dimension": result.dimension,
    }
    if not result.is_run:
        why = result.absent if result.untaken is None else f"{UNTAKEN}{result.untaken}"
        yield {**case, "message": why}
    for outcome in result.outcomes if result.is_run else ():
        amiss = outcome.verdict not in NO_FAULT
        alone = replace(result, outcomes=[outcome])
        yield {
            **case,
            "target": outcome.target,
            "version": versions.get(outcome.target) or "",
            "verdict": str(outcome.verdict),
            "was": str(outcome.was) if outcome.was else None,
            "kind": " ".join(outcome.kinds),
            "seconds": outcome.seconds,
            "digest": outcome.digest,
            "message": outcome.message[:LONGEST_MESSAGE] or None,
            "finding": json.dumps(plain_of(alone), separators=(",", ":")) if amiss else None,
        }


def results_of(rows: Iterable[dict[str, Any]]) -> list[CaseResult]:
    """The results behind the rows of one chunk, in order. Outcomes with something amiss come back
    whole, as do their cases; passes and skips without operands, size and log."""
    return [
        _result(list(group))
        for _, group in groupby(
            sorted(rows, key=lambda row: row["number"]), key=lambda row: row["number"]
        )
    ]


def _result(rows: list[dict[str, Any]]) -> CaseResult:
    whole = [result_of(json.loads(row["finding"])) for row in rows if row["finding"]]
    found = {each.outcomes[0].target: each.outcomes[0] for each in whole}
    outcomes = [
        found.get(row["target"]) or _outcome(row) for row in rows if row["target"] is not None
    ]
    base = whole[0] if whole else _bare(rows[0])
    return replace(base, outcomes=outcomes)


def _bare(row: dict[str, Any]) -> CaseResult:
    name, nothing = CaseName(row["case"], row["class"]), (0, 0, "")
    case = CaseResult(row["number"], name, row["scale"], [], "", "", nothing)
    case.dimension, case.family, case.position = row["dimension"], row["family"], row["position"]
    case.coverage, case.needs = row["coverage"], tuple(row["flags"].split())
    if row["target"] is None:
        message = row["message"] or ""
        if message.startswith(UNTAKEN):
            case.untaken = message.removeprefix(UNTAKEN)
        else:
            case.absent = message
    return case


def _outcome(row: dict[str, Any]) -> Outcome:
    verdict = Verdict(row["verdict"])
    reasons = tuple(map(Reason, row["kind"].split())) if verdict is Verdict.WRONG else ()
    return Outcome(
        row["target"],
        verdict,
        reasons,
        row["message"] or "",
        seconds=row["seconds"],
        digest=row["digest"],
        was=Verdict(row["was"]) if row["was"] else None,
    )
