"""A member's texts: its case file and its certificate."""

from __future__ import annotations

import json
from abc import ABC, abstractmethod
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any, Protocol

from minkref.degeneracies.plane.draft import Subject
from minkref.exact import digest

LICENCE = "Apache-2.0"
IN_FULL = 60  # results with up to so many vertices are written in full


class Provable(Protocol):
    """A certificate."""

    def text(self, case: str, title: str, producer: str) -> str: ...


@dataclass(frozen=True)
class CaseTexts(ABC):
    """Writes a case's texts, in the plane or in space, from the case's content alone."""

    subject: Subject
    source: str

    @property
    @abstractmethod
    def id(self) -> str: ...

    @property
    @abstractmethod
    def document(self) -> dict[str, Any]: ...

    @property
    @abstractmethod
    def certificate(self) -> Provable | None: ...

    @cached_property
    def case_text(self) -> str:
        """A member a line: the canonical form of a case file."""
        return canonical_text(self.document)

    @cached_property
    def certificate_text(self) -> str | None:
        """The certificate's text, or None."""
        made = self.certificate
        return None if made is None else made.text(f"{self.id}.json", self.id, "minkref")

    def described(self, operands: dict[str, Any], findings: dict[str, Any]) -> dict[str, Any]:
        """case-v1. `operands`: dimension, P, Q, scales; `findings`: flags, expected, degeneracy."""
        return {
            "schema": "case-v1",
            "id": self.id,
            "title": self.subject.title,
            **operands,
            "tags": [self.subject.name],
            **findings,
            "source": self.source,
            "licence": LICENCE,
            "certificate": f"{self.id}.cert.json",
        }


def source_of(family: str, seed: int, index: int, size: int | None) -> str:
    """The command that makes member number `index`, with about `size` vertices if given."""
    source = f"minkref generate {family} --seed {seed} --index {index}"
    return source if size is None else f"{source} --size {size}"


def id_of(family: str, content: str, scales: list[str]) -> str:
    """The family, and a hash of operands and scales."""
    return f"{family}-{digest(json.dumps([content, *scales]))[:12]}"


def canonical_text(document: dict[str, Any]) -> str:
    parts = [f'"{name}": {json.dumps(document[name])}' for name in document]
    return "{" + ",\n".join(parts) + "}\n"


def is_double(number: str | Fraction) -> bool:
    value = Fraction(number)
    try:
        return Fraction(float(value)) == value
    except OverflowError:
        return False
