"""Right adapters with another manner of speaking."""

from __future__ import annotations

import json
import sys
import time
from typing import Any

from conversation import Answer, Request
from plane_adapter import Plane


class SlowStart(Plane):
    """Needs three seconds for `hello`."""

    def hello(self) -> Answer:
        time.sleep(3)
        return super().hello()


class LogsMuch(Plane):
    """Writes a log on standard error at each request, with bytes that are no UTF-8."""

    def answer(self, request: Request) -> Answer:
        sys.stderr.buffer.write(b"\xff\xfe" + f"asked {request['verb']}\n".encode() * 50)
        sys.stderr.flush()
        return super().answer(request)


class FurtherMembers(Plane):
    """Adds members that the page does not know to each answer; in `hello` their names begin as it
    asks."""

    def answer(self, request: Request) -> Answer:
        answer = {**super().answer(request), "x-note": {"verb": request["verb"]}}
        return answer if request["verb"] == "hello" else {**answer, "seconds": 0.1}


class KeysInAnotherOrder(Plane):
    """Members in reverse order, with blank space around each JSON word."""

    def line(self, seq: Any, answer: Answer) -> str:
        members = dict(reversed(list({"seq": seq, **answer}.items())))
        return "  " + json.dumps(members, separators=(" ,\t", " :  ")) + " \t"


class UnicodeEscapes(Plane):
    """Letters of keys and texts as escapes, a name beyond ASCII."""

    def hello(self) -> Answer:
        return {**super().hello(), "name": "Σ ⊕ \U0001f600"}

    def line(self, seq: Any, answer: Answer) -> str:
        text = super().line(seq, answer)
        return text.replace("status", "st\\u0061tus").replace('"1', '"\\u0031')


class SilentStop(Plane):
    """Ends on `stop` without a word."""

    def serve(self) -> None:
        for text in sys.stdin:
            request = json.loads(text)
            if request["verb"] == "stop":
                return
            print(self.line(request["seq"], self.answer(request)), flush=True)


class EndsWithTheInput(Plane):
    """Answers `stop` and ends when its input does, with a newline of two bytes."""

    def serve(self) -> None:
        for text in sys.stdin:
            request = json.loads(text)
            if request["verb"] == "stop":
                print(self.line(request["seq"], {"status": "result"}), flush=True)
            else:
                sys.stdout.write(self.line(request["seq"], self.answer(request)) + "\r\n")
                sys.stdout.flush()
