"""The loop of an adapter, written from docs/adapter-protocol.md alone: a line in, a line out."""

from __future__ import annotations

import json
import sys
from fractions import Fraction
from typing import Any, ClassVar

Request = dict[str, Any]
Answer = dict[str, Any]


class Rejected(Exception):
    """The input is invalid."""


class Adapter:
    """Answers requests; each kind of adapter overrides its differences."""

    declares: ClassVar[dict[str, Any]] = {}

    def hello(self) -> Answer:
        return {
            "protocol": "adapter-v1",
            "name": type(self).__name__,
            "version": "1",
            "language": "Python",
            "arithmetic": "exact",
            "numbers": "text",
            "sum": "region",
            **self.declares,
        }

    def load(self, request: Request) -> Answer:
        """Keeps the operands."""
        self.P, self.Q = request["P"], request["Q"]
        return {}

    def at(self, request: Request) -> Answer:
        raise NotImplementedError

    def update(self, request: Request) -> Answer:
        raise NotImplementedError

    def events(self, request: Request) -> Answer:
        raise NotImplementedError

    def answer(self, request: Request) -> Answer:
        verb = request["verb"]
        try:
            if verb == "hello":
                return {"status": "result", **self.hello()}
            if verb in ("load", "at", "update", "events"):
                return {"status": "result", **getattr(self, verb)(request)}
        except Rejected as refusal:
            return {"status": "rejected", "reason": str(refusal)}
        except Exception as error:  # noqa: BLE001 the answer says what went wrong
            return {"status": "errored", "reason": repr(error)}
        return {"status": "skipped", "reason": f"no verb {verb}"}

    def line(self, seq: Any, answer: Answer) -> str:
        return json.dumps({"seq": seq, **answer})

    def serve(self) -> None:
        """Until `stop` or the end of the input."""
        for text in sys.stdin:
            request = json.loads(text)
            if request["verb"] == "stop":
                print(self.line(request["seq"], {"status": "result"}), flush=True)
                return
            print(self.line(request["seq"], self.answer(request)), flush=True)


def number_of(value: Any) -> Fraction:
    """The exact value of a text `n` or `n/d`, or of a JSON number."""
    return Fraction(value)


def text_of(number: Fraction) -> str:
    return str(number)
