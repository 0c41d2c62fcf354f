"""Codes make a ledger hard to forge: each line ends with a code for the line and all lines before
it, under a key kept outside the ledger.

A user's key stands in a file that only this user may read, `ledger.key` in `state_folder()`.
Promised: a program that cannot read the key, in the sandbox or as another user, can neither change
nor add a line that a resumed run believes. Not promised: anything against a program that runs as
the same user outside the sandbox and looks for the key. Lines cut off at the end are no lie either
way: a kill leaves the same, and their cases are asked again. Only the first line binds a ledger as
a whole, so that an older copy of the same ledger is believed.
"""

from __future__ import annotations

import fcntl
import hashlib
import hmac
import os
import secrets
from pathlib import Path

from minkref.errors import Refusal
from minkref.fuzz.isolation.own_folders import state_folder

KEY_BYTES = 32
_DIGITS = 32  # hexadecimal digits per code
_BEFORE, _AFTER = b',"chain":"', b'"}'


class Chain:
    """The codes for lines in order, from the first on."""

    def __init__(self, key: bytes) -> None:
        self._key = key
        self._last = b""

    @property
    def name(self) -> str:
        """Identifies the key among others, and reveals nothing else about it."""
        return self._code(b"name")[:16].decode()

    def close(self, line: bytes) -> bytes:
        """The next line, the text of a JSON object, with its code as last member."""
        self._last = self._code(self._last + line)
        return line[:-1] + _BEFORE + self._last + _AFTER

    def open(self, line: bytes) -> bytes | None:
        """Returns the next line as given to `close`; None for any line not written so."""
        end = len(line) - len(_BEFORE) - _DIGITS - len(_AFTER)
        plain = line[: max(0, end)] + b"}"
        before = self._last
        if hmac.compare_digest(self.close(plain), line):
            return plain
        self._last = before
        return None

    def _code(self, data: bytes) -> bytes:
        return hmac.new(self._key, data, hashlib.sha256).hexdigest()[:_DIGITS].encode()


def ledger_key() -> bytes:
    """Returns this user's key, made at first use. Refuses if it cannot be stored."""
    path = state_folder() / "ledger.key"
    try:
        key = _read(path) or _made(path)
    except OSError as error:
        raise Refusal(
            f"there is no place for the key of ledgers: {error.strerror}",
            str(path),
            "set XDG_STATE_HOME to a folder that is kept and that you may write to",
            "cannot-write",
        ) from error
    if len(key) != KEY_BYTES:
        mend = "remove it; ledgers that were written under it cannot be gone on with"
        raise Refusal("this is no key of ledgers", str(path), mend, "bad-ledger")
    return key


def _read(path: Path) -> bytes:
    try:
        return path.read_bytes()
    except FileNotFoundError:
        return b""


def _made(path: Path) -> bytes:
    path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
    file = os.open(path, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o600)
    try:
        fcntl.flock(file, fcntl.LOCK_EX)  # if two runs begin at once, one makes the key
        if not os.fstat(file).st_size:
            os.write(file, secrets.token_bytes(KEY_BYTES))
        return os.pread(file, KEY_BYTES + 1, 0)
    finally:
        os.close(file)
