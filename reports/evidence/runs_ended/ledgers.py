"""Changed ledgers: a run resumes a ledger only if its whole lines are a beginning of the written
lines."""

from __future__ import annotations

import json
import os
import random
import tempfile
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

from minkref.errors import Refusal
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.run.ledger import Ledger
from minkref.fuzz.run.ledger_chain import Chain, ledger_key
from minkref.fuzz.run.worker import CaseResult
from minkref.fuzz.verdicts.verdict import Outcome, Reason, Verdict, Witness
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(None, 0.2, 3)

SEED = 20120524
FILES = Counts(0, 6_000, 100_000)
RESULTS = 6
SHOWN = 5
HEAD = {"targets": ["a", "b"], "cases": {"seed": 1}, "limits": {"seconds": 1.5}}
STRANGE: tuple[Any, ...] = (
    *(None, True, -1, 0, 1e308, 2**70, "", "x" * 5000, "\ud800"),
    *([], [[]], {}, {"a": 1}),
)

Change = Callable[[random.Random, bytes, bytes], bytes]


def result(number: int) -> CaseResult:
    witness = Witness(("1/2", "3"), True, ("0", "1"), ("1/2", "2"))
    outcomes = [
        Outcome("a", Verdict.PASS, seconds=0.25),
        Outcome("b", Verdict.WRONG, (Reason.HOLE_LOST,), "lost", witness=witness, got="{}"),
    ]
    name = CaseName(f"random:1:{number}", "random")
    return CaseResult(number, name, "7/5", outcomes, "P", "Q", (7, 1, ""), needs=("plane",))


def written(path: Path, first: int) -> bytes:
    with Ledger(path, HEAD) as ledger:
        for number in range(first, first + RESULTS):
            ledger.write(result(number))
    return path.read_bytes()


def bytes_changed(dice: random.Random, text: bytes, _: bytes) -> bytes:
    data = bytearray(text)
    for _time in range(dice.randint(1, 4)):
        at = dice.randrange(len(data) + 1)
        piece = dice.choice((dice.randbytes(1), b"\n", b'"', b"}", b"0", b"\0", b'","chain":"'))
        match dice.randrange(3):
            case 0:
                data[at : at + 1] = piece
            case 1:
                data[at:at] = piece
            case _:
                del data[at : at + dice.randint(1, 40)]
    return bytes(data)


def lines_changed(dice: random.Random, text: bytes, other: bytes) -> bytes:
    lines = text.splitlines(keepends=True)
    at = dice.randrange(len(lines))
    line = dice.choice(dice.choice((text, other)).splitlines(keepends=True))
    match dice.randrange(5):
        case 0:
            lines[at] = line
        case 1:
            lines.insert(at, line)
        case 2:
            del lines[at]
        case 3:
            dice.shuffle(lines)
        case _:
            lines.append(line[: dice.randrange(len(line) + 1)])
    return b"".join(lines)


def cut(dice: random.Random, text: bytes, _: bytes) -> bytes:
    return text[: dice.randrange(len(text) + 1)]


def signed_anew(dice: random.Random, text: bytes, _: bytes) -> bytes:
    """Changes some values and recomputes the codes for the new content."""
    chain = Chain(ledger_key())
    lines = []
    for line in text.splitlines():
        value = json.loads(line)
        del value["chain"]
        if dice.randrange(3) == 0:
            changed(dice, value)
        lines.append(chain.close(json.dumps(value, separators=(",", ":")).encode()) + b"\n")
    return b"".join(lines)


def changed(dice: random.Random, value: Any) -> None:
    """Changes, removes or adds a member at any depth."""
    keys = list(value) if isinstance(value, dict) else list(range(len(value)))
    key = dice.choice(keys) if keys else None
    if key is not None and isinstance(value[key], dict | list) and dice.randrange(4):
        changed(dice, value[key])
    elif key is not None and dice.randrange(4):
        value[key] = dice.choice((*STRANGE, value[dice.choice(keys)]))
    elif key is not None:
        del value[key]
    elif isinstance(value, dict):
        value["more"] = dice.choice(STRANGE)
    else:
        value.append(dice.choice(STRANGE))


KINDS: dict[str, Change] = {
    "bytes": bytes_changed,
    "lines": lines_changed,
    "cut": cut,
    "signed anew": signed_anew,
}


def outcome(path: Path) -> tuple[str, list[CaseResult]]:
    """The refusal's code, or an empty code and the results; another exception gives its name."""
    try:
        with Ledger(path, HEAD) as ledger:
            known = [ledger.result(k, result(k).name) for k in range(RESULTS)]
            return "", [one for one in known if one is not None]
    except Refusal as refusal:
        return refusal.code or "refused", []
    except Exception as error:  # noqa: BLE001
        return f"{type(error).__name__}: {error}", []


def fault(kind: str, text: bytes, data: bytes, code: str, known: list[CaseResult]) -> str:
    """Which law does not hold, or nothing."""
    if ":" in code:
        return code
    if kind == "signed anew":
        return ""
    # A kill leaves half a line at the end: the reader drops that half, whatever its content.
    whole = data[: data.rfind(b"\n") + 1] or data
    if code:
        return "a beginning is refused" if text.startswith(whole) else ""
    if not text.startswith(whole):
        return "a change is believed"
    written_before = range(whole.count(b"\n") - 1)  # without the head
    return "" if known == [result(k) for k in written_before] else "other results"


def run(findings: Findings, size: Size) -> None:
    files, dice = size.of(FILES), random.Random(SEED)
    told: Counter[tuple[str, str]] = Counter()
    faults: list[str] = []
    with tempfile.TemporaryDirectory() as folder:
        before = os.environ.get("XDG_STATE_HOME")
        os.environ["XDG_STATE_HOME"] = folder  # gives this run its own key
        try:
            text = written(Path(folder, "whole.jsonl"), 0)
            other = written(Path(folder, "other.jsonl"), 100)
            path = Path(folder, "changed.jsonl")
            for number in range(files):
                kind = dice.choice(list(KINDS))
                data = KINDS[kind](dice, text, other)
                path.write_bytes(data)
                code, known = outcome(path)
                told[kind, "believed" if not code else "refused"] += 1
                if wrong := fault(kind, text, data, code, known):
                    faults.append(f"file {number} ({kind}): {wrong}")
        finally:
            if before is None:
                del os.environ["XDG_STATE_HOME"]
            else:
                os.environ["XDG_STATE_HOME"] = before
    findings.figures = {
        "seed": SEED,
        "files": {f"{kind}: {what}": n for (kind, what), n in sorted(told.items())},
    }
    shown = "; ".join(faults[:SHOWN]) or f"none in {files} files"
    findings.law("changed ledgers: findings", not faults, "none", shown)
    for kind in KINDS:
        tried = sum(n for (of, _), n in told.items() if of == kind)
        findings.law(f"{kind}: files", tried > files // 10, f"more than {files // 10}", tried)
