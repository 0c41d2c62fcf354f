"""The findings as SARIF 2.1.0: a rule for each kind, a result for each finding made small."""

from __future__ import annotations

import json
from typing import Any

from minkref.commands.verify_output import describe
from minkref.fuzz.run.runner import Finding
from minkref.fuzz.shrink.groups import Group
from minkref.fuzz.verdicts.verdict import Verdict
from minkref.version import version

SCHEMA = (
    "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json"
)
LEVELS = {Verdict.WRONG: "error", Verdict.KNOWN: "note", Verdict.UNDECIDED: "note"}


def sarif(groups: list[Group], value: dict[str, Any]) -> str:
    rules = sorted({rule for group in groups for rule in [_rule(group)]})
    run = {
        "tool": {
            "driver": {
                "name": "minkref",
                "version": version(),
                "rules": [{"id": rule, "name": rule} for rule in rules],
            }
        },
        "invocations": [{"executionSuccessful": True, "exitCode": value["exit_code"]}],
        "results": [result for group in groups for result in _results(group)],
    }
    return json.dumps({"$schema": SCHEMA, "version": "2.1.0", "runs": [run]}, indent=2) + "\n"


def _rule(group: Group) -> str:
    return "/".join(group.example.outcome.kinds)


def _results(group: Group) -> list[dict[str, Any]]:
    finding = group.example
    shown = [Finding(small.outcome, small.result) for small in group.small] or [finding]
    return [
        {
            "ruleId": _rule(group),
            "level": LEVELS.get(finding.outcome.verdict, "warning"),
            "message": {"text": "\n".join(describe(group))},
            "locations": [
                {
                    "logicalLocations": [
                        {"name": finding.outcome.target, "kind": "module"},
                    ]
                }
            ],
            "partialFingerprints": {
                "minkrefCase/v1": f"{finding.outcome.target} {_rule(group)} {one.case.name.text}"
            },
            "properties": {
                "reproduce": one.reproduce,
                "witness": one.outcome.witness.document() if one.outcome.witness else None,
                "count": group.count,
            },
        }
        for one in shown
    ]
