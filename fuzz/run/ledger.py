"""A run's ledger: one JSON line per result, written before anything is said about the result.

A killed run goes on from its ledger: written results are not run again, and half a line at the end
is dropped. A changed or moved line is refused (ledger_chain.py says against whom this holds).
"""

from __future__ import annotations

import fcntl
import json
import os
import stat
import time
from dataclasses import asdict
from pathlib import Path
from typing import Any, Self

from minkref.errors import Refusal
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.run.ledger_chain import Chain, ledger_key
from minkref.fuzz.run.worker import CaseResult
from minkref.fuzz.verdicts.verdict import Outcome, Reason, Verdict, Witness

FORMAT = "ledger-v3"
LONGEST_HEAD = 64 << 20  # bytes; includes the named cases


class Ledger:
    """Open for appending, by one run at a time. `head` identifies the run: another run's ledger is
    refused."""

    def __init__(self, path: Path, head: dict[str, Any]) -> None:
        self.path = path
        self._chain = Chain(ledger_key())
        self._head = {"ledger": FORMAT, "key": self._chain.name, **head}
        self._known: dict[int, CaseResult] = {}
        self._began = time.monotonic()
        self.spent = 0.0
        try:
            self._file = os.open(path, os.O_RDWR | os.O_CREAT | os.O_APPEND | os.O_CLOEXEC, 0o644)
        except OSError as error:
            what = f"the ledger cannot be written: {error.strerror}"
            raise Refusal(what, str(path), "choose another place", "cannot-write") from error
        try:
            fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            self._read()
        except BlockingIOError as error:
            os.close(self._file)
            what = "another run writes this ledger"
            raise Refusal(what, str(path), "wait for it, or name another file") from error
        except BaseException:
            os.close(self._file)
            raise

    @property
    def count(self) -> int:
        """Counts results left by an earlier part of the run."""
        return len(self._known)

    def result(self, number: int, name: CaseName) -> CaseResult | None:
        """Returns a case's result, if known."""
        known = self._known.get(number)
        if known is not None and known.name != name:
            raise self._foreign(f"case {number} is {known.name.text[:80]!r} there")
        return known

    def write(self, result: CaseResult) -> None:
        """Writes one line, by one system call: the line is complete, whatever happens to us."""
        spent = round(self.spent + time.monotonic() - self._began, 3)
        self._append({**plain_of(result), "spent": spent})

    def close(self) -> None:
        os.close(self._file)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _append(self, value: dict[str, Any]) -> None:
        data = self._chain.close(_line(value)) + b"\n"
        try:
            while data:
                data = data[os.write(self._file, data) :]
        except OSError as error:
            what = f"the ledger cannot be written: {error.strerror}"
            raise Refusal(what, str(self.path), "free some space", "cannot-write") from error

    def _read(self) -> None:
        if not stat.S_ISREG(os.fstat(self._file).st_mode):
            raise Refusal("this is no file", str(self.path), "name a file", "cannot-write")
        text = self._text()
        *lines, half = text.split(b"\n")
        if lines:
            self._read_head(lines[0])
        elif not Chain(ledger_key()).close(_line(self._head)).startswith(half):
            raise self._foreign("its first line is none of a ledger")
        if half:
            os.ftruncate(self._file, len(text) - len(half))
        if not lines:
            self._append(self._head)
            return
        for number, line in enumerate(lines[1:], 2):
            value = self._value(self._opened(line, number), number)
            try:
                result = result_of(value)
                self.spent = float(value["spent"])
            except (KeyError, IndexError, TypeError, ValueError, AttributeError) as error:
                what = f"line {number} is no result: {error}"
                raise Refusal(what, str(self.path), "remove the file", "bad-ledger") from error
            self._known[result.number] = result

    def _text(self) -> bytes:
        """Returns the whole text, if the first line's length is allowed."""
        try:
            with self.path.open("rb") as stream:
                head = stream.readline(LONGEST_HEAD + 1)
                if len(head) > LONGEST_HEAD:
                    raise self._foreign("its first line is none of a ledger")
                return head + stream.read()
        except OSError as error:
            what = f"the ledger cannot be read: {error.strerror}"
            raise Refusal(what, str(self.path), "name another file", "cannot-read") from error

    def _read_head(self, line: bytes) -> None:
        head = self._value(line, 1)
        if not isinstance(head, dict) or not str(head.get("ledger")).startswith("ledger-v"):
            raise self._foreign("its first line is none of a ledger")
        if head["ledger"] != FORMAT:
            raise self._foreign(f"it is a {head['ledger']!s:.20}, of another version of minkref")
        if head.get("key") != self._head["key"]:
            raise Refusal(
                "this ledger was written under another key, so that nobody can tell whether its "
                "results are forged",
                str(self.path),
                "go on as the user and on the machine that wrote it (or set XDG_STATE_HOME to the "
                "folder with its minkref/ledger.key), or name another file",
                "other-key",
            )
        self._opened(line, 1)
        del head["chain"]
        if head != json.loads(json.dumps(self._head)):
            raise self._foreign("its first line names other targets, cases or limits")

    def _opened(self, line: bytes, number: int) -> bytes:
        opened = self._chain.open(line)
        if opened is None:
            raise Refusal(
                f"line {number} is not what the run wrote there: the file was changed since",
                str(self.path),
                "remove the file and begin again",
                "bad-ledger",
            )
        return opened

    def _value(self, line: bytes, number: int) -> Any:
        try:
            return json.loads(line)
        except (ValueError, RecursionError) as error:
            what = f"line {number} is not JSON"
            raise Refusal(what, str(self.path), "remove the file", "bad-ledger") from error

    def _foreign(self, what: str) -> Refusal:
        return Refusal(
            f"this is the ledger of another run: {what}",
            str(self.path),
            "give the options of that run, or name another file",
            "other-ledger",
        )


def _line(value: dict[str, Any]) -> bytes:
    return json.dumps(value, separators=(",", ":")).encode()


def plain_of(result: CaseResult) -> dict[str, Any]:
    """Returns the result as plain JSON, without what is empty."""
    value = asdict(result)
    value["outcomes"] = [
        {name: field for name, field in outcome.items() if field not in (None, "", ())}
        for outcome in value["outcomes"]
    ]
    return {name: field for name, field in value.items() if field is not None}


def result_of(value: dict[str, Any]) -> CaseResult:
    """Reads what `plain_of` returned. Raises KeyError, TypeError and such for anything else."""
    fields = {name: field for name, field in value.items() if name != "spent"}
    if type(value["number"]) is not int or {type(n) for n in value["name"].values()} != {str}:
        raise TypeError("its case has no number and name")
    fields["name"] = CaseName(**value["name"])
    fields["outcomes"] = [_outcome(outcome) for outcome in value["outcomes"]]
    fields["needs"] = tuple(value.get("needs", ()))
    fields["size"] = (value["size"][0], value["size"][1], value["size"][2])
    return CaseResult(**fields)


def _outcome(value: dict[str, Any]) -> Outcome:
    fields = dict(value)
    fields["verdict"] = Verdict(value["verdict"])
    fields["reasons"] = tuple(Reason(reason) for reason in value.get("reasons", ()))
    if value.get("was"):
        fields["was"] = Verdict(value["was"])
    if value.get("witness"):
        witness: dict[str, Any] = value["witness"]
        points: dict[str, Any] = {
            k: tuple(v) if isinstance(v, list) else v for k, v in witness.items()
        }
        fields["witness"] = Witness(**points)
    return Outcome(**fields)
