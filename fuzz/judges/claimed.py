"""A claim about a witness, in words and as a certificate, not yet checked."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from minkref.fuzz.verdicts.verdict import Witness

NO_FORM = "no form of certificate for this"


class NoForm(Exception):
    """No certificate can state the witness."""

    def __init__(self, why: str) -> None:
        super().__init__(f"{NO_FORM}: {why}")


class AnyCertificate(Protocol):
    def case(self) -> str: ...

    def text(self, case: str, title: str = "", producer: str = "") -> str: ...


@dataclass(frozen=True)
class Claimed:
    words: str
    certificate: AnyCertificate


def place_text(witness: Witness) -> str:
    return f"({', '.join(witness.point)})"
