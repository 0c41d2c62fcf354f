"""The baseline: known faults in known versions, each with a reason. A listed fault becomes
`known`."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from fnmatch import fnmatchcase
from pathlib import Path
from typing import Any

from minkref.errors import Refusal, choice, cut
from minkref.file_text import text_of_file
from minkref.fuzz.verdicts.verdict import BROKEN, GOOD, Outcome, Reason, Verdict

_FIELDS = ("target", "version", "kind", "reason")
_NO_FAULT = (*GOOD, Verdict.SKIPPED, Verdict.UNDECIDED, Verdict.KNOWN)
KINDS = tuple(str(kind) for kind in (*Reason, *BROKEN, Verdict.GAVE_UP))


@dataclass(frozen=True)
class Entry:
    """`target` and `version` may contain file name wild cards; `kind` is a reason for `wrong`, or a
    verdict such as `crashed`."""

    target: str
    version: str
    kind: str
    reason: str


@dataclass(frozen=True)
class Baseline:
    entries: tuple[Entry, ...] = ()

    def matching(self, target: str, version: str | None) -> list[Entry]:
        return [
            entry
            for entry in self.entries
            if fnmatchcase(target, entry.target) and fnmatchcase(version or "", entry.version)
        ]

    def apply(self, outcome: Outcome, version: str | None) -> Outcome:
        """Returns `known` iff every kind of the outcome's fault is listed for its target and
        version."""
        if outcome.verdict in _NO_FAULT:
            return outcome
        reasons = [self._reason(outcome.target, version or "", kind) for kind in outcome.kinds]
        if not reasons or any(reason is None for reason in reasons):
            return outcome
        return outcome.known("; ".join(dict.fromkeys(r for r in reasons if r is not None)))

    def _reason(self, target: str, version: str, kind: str) -> str | None:
        entries = self.matching(target, version)
        return next((entry.reason for entry in entries if entry.kind == kind), None)


def read_baseline(path: Path) -> Baseline:
    """Reads a baseline. Refuses anything except `{"baseline": "baseline-v1", "entries": [...]}`
    with texts in all fields, and no others."""
    mend = 'write {"baseline": "baseline-v1", "entries": [{"target", "version", "kind", "reason"}]}'
    text = text_of_file(path, str(path), "check the path")
    try:
        value: Any = json.loads(text, object_pairs_hook=_once_each)
    except (ValueError, RecursionError) as error:
        raise Refusal(f"the baseline is not JSON: {cut(str(error))}", str(path), mend) from error
    if not isinstance(value, dict) or value.get("baseline") != "baseline-v1":
        raise Refusal("this is not a baseline of version 1", str(path), mend)
    _refuse_unknown(value, ("baseline", "entries"), "the baseline", str(path))
    entries = value.get("entries")
    if not isinstance(entries, list):
        raise Refusal("the baseline has no list of entries", str(path), mend)
    for number, entry in enumerate(entries):
        if not isinstance(entry, dict) or any(
            not isinstance(entry.get(field), str) or not entry[field] for field in _FIELDS
        ):
            raise Refusal(f"entry {number} lacks one of {', '.join(_FIELDS)}", str(path), mend)
        _refuse_unknown(entry, _FIELDS, f"entry {number}", str(path))
        if entry["kind"] not in KINDS:
            raise Refusal(
                f"entry {number} has the kind {entry['kind'][:40]!r}, which does not exist",
                str(path),
                choice(entry["kind"], KINDS),
            )
    return Baseline(tuple(Entry(*(entry[field] for field in _FIELDS)) for entry in entries))


def accepting(
    baseline: Baseline, faults: Iterable[tuple[Outcome, str]], versions: Mapping[str, str | None]
) -> str:
    """The text of a baseline that lists all faults, after the entries of `baseline`. A fault is an
    outcome with the name of its case; one entry for each target, version and kind."""
    rows = {(e.target, e.version, e.kind): e.reason for e in baseline.entries}
    for outcome, case in faults:
        if outcome.verdict in _NO_FAULT:
            continue
        version = versions.get(outcome.target)
        for kind in outcome.kinds:
            row = (_literal(outcome.target), _literal(version or "*"), kind)
            rows.setdefault(row, f"accepted as found on {case}")
    entries = [dict(zip(_FIELDS, (*row, reason), strict=True)) for row, reason in rows.items()]
    return json.dumps({"baseline": "baseline-v1", "entries": entries}, indent=2) + "\n"


def _literal(text: str) -> str:
    """A pattern that matches the text alone; `*` is left, which matches it too."""
    return text.replace("[", "[[]").replace("?", "[?]")


def _once_each(members: list[tuple[str, Any]]) -> dict[str, Any]:
    value = dict(members)
    if len(value) < len(members):
        raise ValueError("a member occurs twice")
    return value


def _refuse_unknown(value: dict[str, Any], known: Sequence[str], where: str, path: str) -> None:
    for member in value:
        if member not in known:
            what = f"{where} has the member {member[:40]!r}, which nothing reads"
            raise Refusal(what, path, choice(member, known))


def unused(
    baseline: Baseline, outcomes: Iterable[Outcome], versions: Mapping[str, str | None]
) -> list[str]:
    """A sentence for each entry about a target in this run, in its version, that no outcome met."""
    met = {(outcome.target, kind) for outcome in outcomes for kind in outcome.kinds}
    return [
        f"the baseline lists {entry.kind} of {target}, which this run did not meet"
        for target, version in versions.items()
        for entry in baseline.matching(target, version)
        if (target, entry.kind) not in met
    ]
