"""A member's texts: its case file and its certificate."""

from __future__ import annotations

import json
from abc import ABC, abstractmethod
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any, ClassVar, Generic, Protocol, Self

from minkref.degeneracies.family import F, Family, Subject
from minkref.exact import digest

LICENCE = "Apache-2.0"
IN_FULL = 60  # results with up to so many vertices are written in full


class Provable(Protocol):
    """A certificate."""

    def text(self, case: str, title: str, producer: str) -> str: ...


@dataclass(frozen=True)
class CaseTexts(ABC, Generic[F]):
    """Writes a case's texts, in any setting, from the case's content alone. `shown`: what its
    family's `belongs` gave."""

    subject: Subject
    source: str
    facts: F
    shown: Any = None

    schema: ClassVar[str] = "case-v1"
    certified: ClassVar[bool] = True

    @classmethod
    def of(cls, family: Family[Any, F], seed: int, index: int, size: int | None = None) -> Self:
        """Makes member number `index`, with about `size` vertices if given."""
        source = f"minkref generate {family.name} --seed {seed} --index {index}"
        if size is not None:
            source += f" --size {size}"
        return cls(family, source, *family.member(seed, index, size))

    @property
    @abstractmethod
    def content(self) -> str:
        """Equal for equal operands."""

    @staticmethod
    def scales_in(value: dict[str, Any]) -> list[str]:
        """The numbers of a document that its id depends on, beside the operands."""
        return list(map(text_of, value["scales"]))

    @property
    @abstractmethod
    def operands(self) -> dict[str, Any]:
        """The document's members about the question: operands and scales."""

    @property
    @abstractmethod
    def findings(self) -> dict[str, Any]:
        """The document's members about the answer: flags, expected, degeneracy."""

    @property
    def certificate(self) -> Provable | None:
        """None where a setting has no certificates."""
        return None

    @cached_property
    def id(self) -> str:
        return id_of(self.subject.name, self.content, self.scales_in(self.operands))

    @cached_property
    def document(self) -> dict[str, Any]:
        """The case file's members, in their order."""
        return {
            "schema": self.schema,
            "id": self.id,
            "title": self.subject.title,
            **self.operands,
            "tags": [self.subject.name],
            **self.findings,
            "source": self.source,
            "licence": LICENCE,
            **({"certificate": f"{self.id}.cert.json"} if self.certified else {}),
        }

    @cached_property
    def case_text(self) -> str:
        """A member a line: the canonical form of a case file."""
        return canonical_text(self.document)

    @cached_property
    def certificate_text(self) -> str | None:
        """The certificate's text, or None."""
        made = self.certificate
        return None if made is None else made.text(f"{self.id}.json", self.id, "minkref")


def id_of(family: str, content: str, scales: list[str]) -> str:
    """The family, and a hash of operands and scales."""
    return f"{family}-{digest(json.dumps([content, *scales]))[:12]}"


def text_of(scale: str | list[str]) -> str:
    return scale if isinstance(scale, str) else ",".join(scale)


def canonical_text(document: dict[str, Any]) -> str:
    parts = [f'"{name}": {json.dumps(document[name])}' for name in document]
    return "{" + ",\n".join(parts) + "}\n"


def is_double(number: str | Fraction) -> bool:
    value = Fraction(number)
    try:
        return Fraction(float(value)) == value
    except OverflowError:
        return False
