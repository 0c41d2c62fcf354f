"""The findings as SARIF 2.1.0: a rule for each kind, a result for each finding made small."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any
from urllib.parse import quote

from minkref.fuzz.run.runner import Finding
from minkref.fuzz.shrink.groups import Group
from minkref.fuzz.verdicts.verdict import Verdict
from minkref.output.terminal import escaped
from minkref.reports.conformance.run_words import describe
from minkref.reports.conformance.words import meaning
from minkref.version import version

SCHEMA = (
    "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json"
)
LEVELS = {Verdict.WRONG: "error"} | dict.fromkeys(
    (Verdict.KNOWN, Verdict.UNDECIDED, Verdict.GAVE_UP), "note"
)
Kinds = tuple[str, ...]


def sarif(groups: list[Group], value: dict[str, Any]) -> str:
    """SARIF text of the findings; findings listed by the baseline become suppressed notes."""
    rules = sorted({group.example.outcome.kinds for group in groups})
    run = {
        "tool": {
            "driver": {
                "name": "minkref",
                "version": version(),
                "rules": [_rule(kinds) for kinds in rules],
            }
        },
        "invocations": [{"executionSuccessful": True, "exitCode": value["exit_code"]}],
        "results": [
            result
            for group in groups
            for result in _results(group, rules.index(group.example.outcome.kinds))
        ],
        "properties": {
            "seed": value["seed"],
            "targets": [
                {"name": row["name"], "version": row["version"]} for row in value["targets"]
            ],
        },
    }
    return json.dumps({"$schema": SCHEMA, "version": "2.1.0", "runs": [run]}, indent=2) + "\n"


def _rule_id(kinds: Kinds) -> str:
    return "+".join(kinds)


def _rule(kinds: Kinds) -> dict[str, Any]:
    text = "; ".join(meaning(kind) for kind in kinds)
    return {
        "id": _rule_id(kinds),
        "shortDescription": {"text": text},
        "fullDescription": {"text": f"The answer of a target: {text}."},
    }


def place(target: str) -> str:
    """A file for code scanning, which shows no result without a file: the target's file, relative
    to the current folder and below it; else the target's name."""
    words = [target]
    if target.startswith("cmd:"):
        words = target.removeprefix("cmd:").split()
    elif target.startswith("py:"):
        words = [target.split(":")[1].replace(".", "/") + ".py"]
    elif target.startswith("so:"):
        words = [target.split(":")[1]]
    here = Path.cwd()
    for word in words:
        try:
            path = (here / word).resolve()
            if path.is_file() and path.is_relative_to(here):
                return quote(bytes(path.relative_to(here)))
        except (OSError, ValueError):
            continue  # no name of a file: too long, or with a null byte
    return quote(target, safe="", errors="backslashreplace")


def _without_links(text: str) -> str:
    """SARIF has links in plain texts too: `[text](address)`."""
    return text.replace("](", "] (")


def _results(group: Group, rule: int) -> list[dict[str, Any]]:
    finding = group.example
    outcome = finding.outcome
    found = [Finding(small.outcome, small.result) for small in group.small] or [finding]
    results = []
    for one in found:
        result: dict[str, Any] = {
            "ruleId": _rule_id(outcome.kinds),
            "ruleIndex": rule,
            "level": LEVELS.get(outcome.verdict, "warning"),
            "message": {"text": _without_links("\n".join(describe(group)))},
            "locations": [
                {
                    "physicalLocation": {
                        "artifactLocation": {"uri": place(outcome.target)},
                        "region": {"startLine": 1},
                    },
                    "logicalLocations": [{"name": escaped(outcome.target), "kind": "module"}],
                }
            ],
            "partialFingerprints": {
                "minkrefCase/v1": escaped(
                    f"{outcome.target} {_rule_id(outcome.kinds)} {one.case.name.text}"
                )
            },
            "properties": {
                "reproduce": one.reproduce,
                "witness": one.outcome.witness.document() if one.outcome.witness else None,
                "count": group.count,
            },
        }
        if outcome.verdict is Verdict.KNOWN:
            reason = escaped(outcome.message)
            result["suppressions"] = [{"kind": "external", "justification": reason}]
        results.append(result)
    return results
