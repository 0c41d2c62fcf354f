"""The value of an expression with roots, as `1/2 - 3/4*sqrt(5)`."""

from __future__ import annotations

import re
from typing import Any

import gmpy2
from minkref.reports.evidence.as_written.units import Real

TOKEN = re.compile(r"\s*(\d+|sqrt|[-+*/()])")


def value(text: str) -> Real:
    """A rational number if the text takes no root, else a number of 1,500 bits."""
    tokens: list[str] = []
    at = 0
    while at < len(text.rstrip()):
        found = TOKEN.match(text, at)
        if not found:
            raise ValueError(f"no expression at {text[at : at + 20]!r}")
        tokens.append(found[1])
        at = found.end()
    reader = _Reader(tokens)
    result = reader.sum()
    if reader.next:
        raise ValueError(f"{reader.next!r} behind an expression")
    return result


class _Reader:
    def __init__(self, tokens: list[str]) -> None:
        self.tokens, self.at = tokens, 0

    @property
    def next(self) -> str:
        return self.tokens[self.at] if self.at < len(self.tokens) else ""

    def take(self, *wanted: str) -> str:
        if self.next not in wanted:
            return ""
        self.at += 1
        return self.tokens[self.at - 1]

    def sum(self) -> Any:
        result = self.product()
        while sign := self.take("+", "-"):
            term = self.product()
            result = result + term if sign == "+" else result - term
        return result

    def product(self) -> Any:
        result = self.factor()
        while sign := self.take("*", "/"):
            other = self.factor()
            result = result * other if sign == "*" else result / other
        return result

    def factor(self) -> Any:
        if self.take("-"):
            return -self.factor()
        if self.take("sqrt"):
            return gmpy2.sqrt(gmpy2.mpfr(self.bracket()))
        if self.next == "(":
            return self.bracket()
        if not self.next.isdigit():
            raise ValueError(f"{self.next!r} where a number is wanted")
        self.at += 1
        return gmpy2.mpq(int(self.tokens[self.at - 1]))

    def bracket(self) -> Any:
        if not self.take("("):
            raise ValueError("a root has brackets")
        result = self.sum()
        if not self.take(")"):
            raise ValueError("a bracket is not closed")
        return result
